// SPDX-License-Identifier: MIT
#include "polhode/measure/block_means.hpp"

namespace polhode {
namespace {

constexpr std::size_t max_blocks = 40;

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

void TimeBlocks::add(std::span<const double> sample, double weight) {
  if (blocks.empty()) samples_per_block = weight;
  if (blocks.empty() || blocks.back().weight >= samples_per_block) {
    if (blocks.size() == max_blocks) {
      for (std::size_t b = 0; b < max_blocks / 2; ++b) {
        BlockMeans::Block joined = blocks[2 * b];
        join(joined, blocks[2 * b + 1]);
        blocks[b] = std::move(joined);
      }
      blocks.resize(max_blocks / 2);
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
