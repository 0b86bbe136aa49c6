// SPDX-License-Identifier: MIT
// Sums of quantities in consecutive blocks of time.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace polhode {

/// Several quantities, summed in each of a number of blocks.
class BlockMeans {
 public:
  struct Block {
    double weight = 0;  ///< number of samples, or any other measure of size
    std::vector<double> sum;
  };

  BlockMeans() = default;
  explicit BlockMeans(std::vector<Block> blocks) : blocks_(std::move(blocks)) {}

  const std::vector<Block>& blocks() const { return blocks_; }
  bool empty() const { return blocks_.empty(); }

  /// All blocks in one.
  Block sum() const;
  /// Mean of all blocks; empty if there are none.
  std::vector<double> mean() const;

 private:
  std::vector<Block> blocks_;
};

/// Samples of a stream of unknown length, in blocks of time. When there are 40 blocks, neighbours
/// are joined: a run of any length ends with 20 to 39 blocks, in constant memory.
struct TimeBlocks {
  std::vector<BlockMeans::Block> blocks;
  double samples_per_block = 1;

  /// @param weight  samples that were summed already, or any other measure of size
  void add(std::span<const double> sample, double weight = 1);
  /// The blocks; a last block that is less than half full is joined to the block before it.
  BlockMeans means() const;
};

}  // namespace polhode
