// SPDX-License-Identifier: MIT
// Sums of quantities in consecutive blocks of time.
#pragma once

#include <span>
#include <vector>

namespace polhode {

/// Sums of several quantities over each of several blocks.
class BlockMeans {
 public:
  struct Block {
    double weight = 0;  ///< number of samples, or any other weight of the block
    std::vector<double> sum;
  };

  BlockMeans() = default;
  explicit BlockMeans(std::vector<Block> blocks) : blocks_(std::move(blocks)) {}

  const std::vector<Block>& blocks() const { return blocks_; }
  bool empty() const { return blocks_.empty(); }

  /// The sum over all blocks, as one block.
  Block sum() const;
  /// The mean of each quantity over all blocks; empty without blocks.
  std::vector<double> mean() const;

 private:
  std::vector<Block> blocks_;
};

/// Collects samples of a stream of unknown length in blocks of time. When there are 40 blocks,
/// neighbouring blocks are merged. A run of any length therefore ends with 20 to 39 blocks and
/// needs constant memory.
struct TimeBlocks {
  std::vector<BlockMeans::Block> blocks;
  double samples_per_block = 1;

  /// Adds a sample.
  /// @param weight  number of samples whose sum is added, or any other weight
  void add(std::span<const double> sample, double weight = 1);
  /// The blocks as means. If the last block is less than half full, it is merged into the previous
  /// block.
  BlockMeans means() const;
};

}  // namespace polhode
