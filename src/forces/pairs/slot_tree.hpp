// SPDX-License-Identifier: MIT
// A tree of bounding boxes over the slots of each molecule type, for the partner search. Slots are
// in the order of cells, so that consecutive slots are close in space. A leaf bounds a few
// consecutive slots, and a node bounds the leaves or nodes below the node.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "forces/pairs/cells.hpp"
#include "polhode/base/column.hpp"

namespace polhode {

/// Fixed-point units per box edge, chosen so that periodic images on both sides of the box fit into
/// 32 bits.
inline constexpr std::int64_t fixed_point_edge = 1 << 30;

/// The boxes of one level of a tree. Empty boxes after the last box fill the level up to a multiple
/// of SlotTree::fanout. Empty boxes are never in range.
struct BoxLevel {
  std::size_t size = 0;
  std::array<std::vector<std::int32_t>, 3> centre;  ///< centres of the boxes in fixed point
  std::array<Column<float>, 3> half;                ///< half edges of the boxes [nm], rounded up

  explicit BoxLevel(std::size_t boxes);
  void set(std::size_t k, const Vec3<double>& low, const Vec3<double>& high, const Box& box);
};

class SlotTree {
 public:
  static constexpr std::size_t leaf = 16;    ///< number of slots in a leaf
  static constexpr std::size_t fanout = 16;  ///< number of boxes below a node

  explicit SlotTree(const Slots& slots);

  /// Updates the boxes to the current positions of the slots.
  void update(const Slots& slots, const Box& box, Workers& workers);

  /// The levels of the tree of a molecule type, leaves first; the last level has at most `fanout`
  /// boxes.
  const std::vector<BoxLevel>& levels(std::size_t part) const { return trees_[part]; }
  /// Positions of slots relative to the centres of their leaves [nm]; unused slots are far away.
  const std::array<Column<float>, 3>& in_leaf() const { return in_leaf_; }

 private:
  void bound_leaf(std::size_t part, std::size_t k, const Slots& slots, const Box& box);

  std::vector<std::vector<BoxLevel>> trees_;
  std::array<Column<float>, 3> in_leaf_;
};

}  // namespace polhode
