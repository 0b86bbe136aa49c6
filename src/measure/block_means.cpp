// SPDX-License-Identifier: MIT
#include "polhode/measure/block_means.hpp"

#include <cmath>

namespace polhode {
namespace {

constexpr std::size_t most_blocks = 40;

void join(BlockMeans::Block& block, const BlockMeans::Block& other) {
  block.weight += other.weight;
  for (std::size_t k = 0; k < block.sum.size(); ++k) block.sum[k] += other.sum[k];
}

BlockMeans::Block total_of(const std::vector<BlockMeans::Block>& blocks) {
  BlockMeans::Block total = blocks.front();
  for (std::size_t b = 1; b < blocks.size(); ++b) join(total, blocks[b]);
  return total;
}

}  // namespace

std::vector<double> BlockMeans::mean() const {
  if (blocks_.empty()) return {};
  const Block total = total_of(blocks_);
  std::vector<double> mean = total.sum;
  for (double& value : mean) value /= total.weight;
  return mean;
}

std::vector<Estimate> BlockMeans::estimates() const {
  const std::vector<double> means = mean();
  const auto n = static_cast<double>(blocks_.size());
  std::vector<Estimate> result;
  double weight = 0;
  for (const Block& block : blocks_) weight += block.weight;
  for (std::size_t k = 0; k < means.size(); ++k) {
    double squares = 0;  // of the deviations of the blocks' sums from what their weights say
    for (const Block& block : blocks_) {
      const double off = block.sum[k] - block.weight * means[k];
      squares += off * off;
    }
    result.push_back({means[k], n > 1 ? std::sqrt(squares * n / (n - 1)) / weight : 0.0});
  }
  return result;
}

Estimate BlockMeans::estimate(
    const std::function<double(std::span<const double>)>& statistic) const {
  const double value = statistic(mean());
  if (blocks_.size() < 2) return {value, 0};
  const Block total = total_of(blocks_);
  std::vector<double> without, means(total.sum.size());
  for (const Block& block : blocks_) {
    for (std::size_t k = 0; k < means.size(); ++k)
      means[k] = (total.sum[k] - block.sum[k]) / (total.weight - block.weight);
    without.push_back(statistic(means));
  }
  return {value, jackknife_error(without)};
}

void TimeBlocks::add(std::span<const double> sample) {
  if (blocks_.empty() || blocks_.back().weight >= samples_per_block_) {
    if (blocks_.size() == most_blocks) {
      for (std::size_t b = 0; b < most_blocks / 2; ++b) {
        BlockMeans::Block joined = blocks_[2 * b];
        join(joined, blocks_[2 * b + 1]);
        blocks_[b] = std::move(joined);
      }
      blocks_.resize(most_blocks / 2);
      samples_per_block_ *= 2;
    }
    blocks_.push_back({0, std::vector<double>(sample.size(), 0.0)});
  }
  BlockMeans::Block& last = blocks_.back();
  last.weight += 1;
  for (std::size_t k = 0; k < sample.size(); ++k) last.sum[k] += sample[k];
}

BlockMeans TimeBlocks::means() const {
  std::vector<BlockMeans::Block> blocks = blocks_;
  if (blocks.size() > 1 && 2 * blocks.back().weight < samples_per_block_) {
    join(blocks[blocks.size() - 2], blocks.back());
    blocks.pop_back();
  }
  return BlockMeans(std::move(blocks));
}

}  // namespace polhode
