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

}  // namespace

BlockMeans::Block BlockMeans::sum() const {
  if (blocks_.empty()) return {};
  Block total = blocks_.front();
  for (std::size_t b = 1; b < blocks_.size(); ++b) join(total, blocks_[b]);
  return total;
}

std::vector<double> BlockMeans::mean() const {
  if (blocks_.empty()) return {};
  const Block total = sum();
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
  const Block total = sum();
  std::vector<double> without, means(total.sum.size());
  for (const Block& block : blocks_) {
    for (std::size_t k = 0; k < means.size(); ++k)
      means[k] = (total.sum[k] - block.sum[k]) / (total.weight - block.weight);
    without.push_back(statistic(means));
  }
  return {value, jackknife_error(without)};
}

void TimeBlocks::add(std::span<const double> sample, double weight) {
  if (blocks.empty()) samples_per_block = weight;
  if (blocks.empty() || blocks.back().weight >= samples_per_block) {
    if (blocks.size() == most_blocks) {
      for (std::size_t b = 0; b < most_blocks / 2; ++b) {
        BlockMeans::Block joined = blocks[2 * b];
        join(joined, blocks[2 * b + 1]);
        blocks[b] = std::move(joined);
      }
      blocks.resize(most_blocks / 2);
      samples_per_block *= 2;
    }
    blocks.push_back({0, std::vector<double>(sample.size(), 0.0)});
  }
  BlockMeans::Block& last = blocks.back();
  last.weight += weight;
  for (std::size_t k = 0; k < sample.size(); ++k) last.sum[k] += sample[k];
}

BlockMeans TimeBlocks::means() const {
  std::vector<BlockMeans::Block> whole = blocks;
  if (whole.size() > 1 && 2 * whole.back().weight < samples_per_block) {
    join(whole[whole.size() - 2], whole.back());
    whole.pop_back();
  }
  return BlockMeans(std::move(whole));
}

}  // namespace polhode
