// SPDX-License-Identifier: MIT
#include "forces/pairs/slot_tree.hpp"

#include <algorithm>
#include <limits>

#include "base/blocks.hpp"

namespace polhode {
namespace {

constexpr float far_away = 1e15F;  // a distance whose square is a finite float
constexpr std::size_t leaves_at_once = 64;

/// The length of one unit of fixed point along each edge [nm].
Vec3<double> unit_of(const Box& box) {
  return 1.0 / static_cast<double>(fixed_point_edge) * box.edge;
}

}  // namespace

BoxLevel::BoxLevel(std::size_t boxes) : size(boxes) {
  const std::size_t room = blocks(boxes, SlotTree::fanout) * SlotTree::fanout;
  for (std::size_t d = 0; d < 3; ++d)
    centre[d].assign(room, 0), half[d] = Column<float>(room, -far_away);
}

void BoxLevel::set(std::size_t k, const Vec3<double>& low, const Vec3<double>& high,
                   const Box& box) {
  constexpr double round_up = 1 + 0x1p-20;
  const Vec3<double> unit = unit_of(box);
  for (std::size_t d = 0; d < 3; ++d) {
    centre[d][k] = static_cast<std::int32_t>((low[d] + high[d]) / 2 / unit[d]);
    const double at = centre[d][k] * unit[d];
    half[d][k] = static_cast<float>(std::max(at - low[d], high[d] - at) * round_up);
  }
}

SlotTree::SlotTree(const Slots& slots) {
  for (const Slots::Part& part : slots.parts) {
    std::vector<BoxLevel>& levels = trees_.emplace_back();
    for (std::size_t boxes = blocks(part.count, leaf);; boxes = blocks(boxes, fanout)) {
      levels.emplace_back(boxes);
      if (boxes <= fanout) break;
    }
  }
  for (auto& column : in_leaf_) column = Column<float>(slots.size(), far_away);
}

void SlotTree::bound_leaf(std::size_t part, std::size_t k, const Slots& slots, const Box& box) {
  const std::size_t first = slots.parts[part].first + k * leaf;
  const std::size_t end = std::min<std::size_t>(first + leaf, slots.parts[part].end());
  Vec3<double> low = slots.place[first], high = low;
  for (std::size_t s = first + 1; s < end; ++s) {
    const Vec3<double> q = slots.place[s];
    for (std::size_t d = 0; d < 3; ++d)
      low[d] = std::min(low[d], q[d]), high[d] = std::max(high[d], q[d]);
  }
  BoxLevel& leaves = trees_[part].front();
  leaves.set(k, low, high, box);
  const Vec3<double> unit = unit_of(box);
  for (std::size_t d = 0; d < 3; ++d) {
    const double at = leaves.centre[d][k] * unit[d];
    for (std::size_t s = first; s < end; ++s)
      in_leaf_[d][s] = static_cast<float>(slots.place[s][d] - at);
  }
}

void SlotTree::update(const Slots& slots, const Box& box, Workers& workers) {
  const Vec3<double> unit = unit_of(box);
  for (std::size_t part = 0; part < trees_.size(); ++part) {
    std::vector<BoxLevel>& levels = trees_[part];
    each_block(levels[0].size, leaves_at_once, workers, [&](std::size_t first, std::size_t end) {
      for (std::size_t k = first; k < end; ++k) bound_leaf(part, k, slots, box);
    });
    for (std::size_t l = 1; l < levels.size(); ++l)
      for (std::size_t k = 0; k < levels[l].size; ++k) {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        const BoxLevel& below = levels[l - 1];
        Vec3<double> low{infinity, infinity, infinity}, high = -low;
        for (std::size_t b = k * fanout; b < std::min((k + 1) * fanout, below.size); ++b)
          for (std::size_t d = 0; d < 3; ++d) {
            const double at = below.centre[d][b] * unit[d], half = below.half[d][b];
            low[d] = std::min(low[d], at - half), high[d] = std::max(high[d], at + half);
          }
        levels[l].set(k, low, high, box);
      }
  }
}

}  // namespace polhode
