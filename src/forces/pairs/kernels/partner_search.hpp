// SPDX-License-Identifier: MIT
// The search for the partners of bodies in the tree of boxes, in packs. The search finds the leaves
// in range of a leaf, then the leaves in range of each body of this leaf, and finally the bodies in
// these leaves.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/pack_compress.hpp"
#include "forces/pairs/row_packing.hpp"
#include "polhode/base/always_inline.hpp"
#include "polhode/base/column.hpp"

namespace polhode::POLHODE_LOOPS {
namespace {

// Upper bound on the round-off of distances. Fixed-point positions have errors of 2⁻³⁰ of an edge,
// and float distances have relative errors of 2⁻²². For distances of a few nm, the bound is larger
// than both errors.
constexpr double rounding = 1e-5;  // [nm]

using Real = Pack<float>;

// A table of list entries, with a separate array for each field.
template <std::size_t columns>
struct Table {
  std::size_t size = 0;
  std::vector<std::uint32_t> words;
  std::array<std::vector<float, AlignedAllocator<float>>, columns> numbers;

  // Makes room for n more entries and for a pack past the end, because packs are stored as a whole.
  void reserve(std::size_t n) {
    if (words.size() >= size + n + Real::width) return;
    words.resize(std::max<std::size_t>(128, 2 * (size + n) + Real::width));
    for (auto& column : numbers) column.resize(words.size());
  }
  void push(Neighbour node) {
    reserve(1);
    words[size++] = node.word();
  }
  void swap(std::size_t a, std::size_t b) {
    std::swap(words[a], words[b]);
    for (auto& column : numbers) std::swap(column[a], column[b]);
  }
  POLHODE_INLINE void add(const Selection& selected, PackIndex<float> word,
                          const std::array<Real, columns>& number) {
    selected.store(word, words.data() + size);
    for (std::size_t k = 0; k < columns; ++k) selected.store(number[k], &numbers[k][size]);
    size += selected.count();
  }
};

using Nodes = Table<0>;   // nodes of the tree, stored as slots
using Found = Table<1>;   // partners, with their squared distance [nm²]
using Leaves = Table<6>;  // first slots of leaves, with centre and half edges of the box [nm]
using Shifts = Table<3>;  // first slots of leaves, with their centre relative to a body [nm]

// The square of the distance between two boxes, given the difference of their centres and the sums
// of their half edges; 0 if the boxes overlap.
inline Real distance2(const Vec3<Real>& centres, const Vec3<Real>& halves) {
  Real sum;
  for (std::size_t d = 0; d < 3; ++d) {
    const Real gap = max(abs(centres[d]) - halves[d], Real(0));
    sum += gap * gap;
  }
  return sum;
}

// Finds the partners of bodies one after the other. The bodies of a leaf share the list of leaves
// in range.
//
// Leaves of one molecule type have a cyclic order. Leaf b is ahead of leaf a if b follows a in this
// order by at most half the number of leaves. If leaf b is ahead of leaf a, a pair of bodies in a
// and b is found only from the body in leaf a. Within a leaf, the pair is found from the body in
// the lower slot.
class Search {
 public:
  Search(const ListJob& job, const ListChunk& chunk, std::size_t partner_part)
      : job_(job),
        own_(job.tree.levels(chunk.part)[0]),
        partners_(job.tree.levels(partner_part)),
        own_first_(job.slots.parts[chunk.part].first),
        partner_first_(job.slots.parts[partner_part].first),
        chunk_end_(chunk.end),
        same_(chunk.part == partner_part) {
    const PairRange& range = job.ranges[chunk.part * job.slots.parts.size() + partner_part];
    const double listed = std::sqrt(range.listed2) + rounding;
    listed2_ = static_cast<float>(listed * listed);
    for (std::size_t d = 0; d < 3; ++d)
      unit_[d] = static_cast<float>(job.box.edge[d] / static_cast<double>(fixed_point_edge));
  }

  // Appends the partners of a slot to its row.
  void operator()(std::uint32_t slot, Found& found) {
    const std::size_t leaf = (slot - own_first_) / SlotTree::leaf;
    if (leaf != leaf_) gather_leaves(leaf_ = leaf);
    Vec3<float> at;
    for (std::size_t d = 0; d < 3; ++d) at[d] = job_.tree.in_leaf()[d][slot];
    select_leaves(at);
    found.reserve((own_images_.size() + near_.size) * SlotTree::leaf);
    const std::uint32_t first = own_first_ + static_cast<std::uint32_t>(leaf * SlotTree::leaf);
    for (const OwnImage& image : own_images_)
      scan_later(Neighbour(first | image.bits), slot - first, image.shift - at, found);
    scan_near(found);
  }

  // Calls visit(first slot) for each leaf in range of the last leaf searched.
  template <class Visit>
  void each_leaf(const Visit& visit) const {
    for (std::size_t k = 0; k < leaves_.size; ++k) visit(Neighbour(leaves_.words[k]).slot());
  }

 private:
  // A periodic image of the leaf of a body.
  struct OwnImage {
    std::uint32_t bits;
    Vec3<float> shift;  // shift of the image [nm]
  };

  // Collects the leaves in range of a leaf, by descending the tree level by level.
  void gather_leaves(std::size_t leaf) {
    start(leaf);
    for (std::size_t l = partners_.size(); l-- > 1;) {
      next_.size = 0;
      for (std::size_t k = 0; k < nodes_.size; ++k) open(partners_[l], Neighbour(nodes_.words[k]));
      std::swap(nodes_, next_);
    }
    leaves_.size = 0;
    for (std::size_t k = 0; k < nodes_.size; ++k) open_to_leaves(Neighbour(nodes_.words[k]));
    if (same_) bring_takers_to_front();
  }

  // Moves leaves to the front of the list if they follow the body's leaf closely in the chunk. The
  // rows of slots in the leaves at the front can then take over surplus pairs.
  void bring_takers_to_front() {
    const auto own = own_first_ + static_cast<std::uint32_t>(leaf_ * SlotTree::leaf);
    const std::uint32_t end = std::min(chunk_end_, own + HandedPairs::window);
    std::size_t front = 0;
    for (std::size_t k = 0; k < leaves_.size; ++k)
      if (const std::uint32_t slot = Neighbour(leaves_.words[k]).slot(); slot > own && slot < end)
        leaves_.swap(k, front++);
  }

  // For a leaf, finds the periodic images of the root box and of the leaf itself that are in range
  // of the leaf.
  void start(std::size_t leaf) {
    nodes_.size = 0;
    own_images_.clear();
    std::array<std::array<double, 3>, 3> root2, own2;  // squared gaps to the root and to the leaf,
                                                       // by direction and image
    for (std::size_t d = 0; d < 3; ++d) {
      at_[d] = own_.centre[d][leaf], half_[d] = own_.half[d][leaf];
      const double edge = job_.box.edge[d], half = half_[d];
      const double at = at_[d] * edge / static_cast<double>(fixed_point_edge);
      for (int k = 0; k < 3; ++k) {
        const double from = (k - 1) * edge;
        const double root = std::max({0.0, from - at - half, at - half - from - edge});
        const double own = std::max(0.0, std::abs(from) - 2 * half);
        root2[d][static_cast<std::size_t>(k)] = root * root;
        own2[d][static_cast<std::size_t>(k)] = own * own;
      }
    }
    for (std::size_t k = 0; k < 27; ++k) {
      const std::array<std::size_t, 3> digit{k % 3, k / 3 % 3, k / 9};
      const auto sum = [&](const auto& gap2) {
        return gap2[0][digit[0]] + gap2[1][digit[1]] + gap2[2][digit[2]];
      };
      const auto edges = [&](std::size_t d) { return static_cast<int>(digit[d]) - 1; };
      const Neighbour::Image image{edges(0), edges(1), edges(2)};
      if (sum(root2) < listed2_) nodes_.push(Neighbour(0, image));
      if (!same_ || !(sum(own2) < listed2_)) continue;
      Vec3<float> shift;
      for (std::size_t d = 0; d < 3; ++d)
        shift[d] = static_cast<float>(image[d] * job_.box.edge[d]);
      own_images_.push_back({Neighbour::bits(image), shift});
    }
  }

  // Boxes of a tree level that are in range of a leaf.
  struct InRange {
    Vec3<Real> centre, half;  // centre and half edges [nm], relative to the centre of the leaf
    Mask<Real> is;
  };
  POLHODE_INLINE InRange in_range(const BoxLevel& level, std::size_t k,
                                  const Vec3<std::int32_t>& from) const {
    InRange boxes;
    Vec3<Real> halves;
    for (std::size_t d = 0; d < 3; ++d) {
      boxes.centre[d] = fixed_point_difference(&level.centre[d][k], from[d]) * Real(unit_[d]);
      boxes.half[d] = Real::load(&level.half[d][k]);
      halves[d] = boxes.half[d] + Real(half_[d]);
    }
    boxes.is = distance2(boxes.centre, halves) < Real(listed2_);
    return boxes;
  }

  // Calls visit(image, index of the first box, boxes) for each pack of the boxes below a node.
  template <class Visit>
  POLHODE_INLINE void below(const BoxLevel& level, Neighbour node, const Visit& visit) const {
    Vec3<std::int32_t> from;
    for (std::size_t d = 0; d < 3; ++d)
      from[d] = at_[d] - node.image()[d] * static_cast<std::int32_t>(fixed_point_edge);
    const std::size_t first = node.slot() * SlotTree::fanout;
    for (std::size_t k = first; k < first + SlotTree::fanout; k += Real::width)
      visit(k, in_range(level, k, from));
  }

  void open(const BoxLevel& level, Neighbour node) {
    next_.reserve(SlotTree::fanout);
    below(level, node, [&](std::size_t k, const InRange& boxes) {
      const std::uint32_t first = static_cast<std::uint32_t>(k) | Neighbour::bits(node.image());
      next_.add(Selection(boxes.is), consecutive(first), {});
    });
  }

  void open_to_leaves(Neighbour node) {
    constexpr auto leaf = static_cast<std::uint32_t>(SlotTree::leaf);
    leaves_.reserve(SlotTree::fanout);
    below(partners_[0], node, [&](std::size_t k, const InRange& boxes) {
      const std::uint32_t first =
          (partner_first_ + static_cast<std::uint32_t>(k) * leaf) | Neighbour::bits(node.image());
      const Vec3<Real>&centre = boxes.centre, &half = boxes.half;
      leaves_.add(Selection(same_ ? boxes.is && ahead(k) : boxes.is), consecutive(first, leaf),
                  {centre.x, centre.y, centre.z, half.x, half.y, half.z});
    });
  }

  // A mask of the leaves that are ahead of the body's leaf, in the pack that begins with leaf k.
  POLHODE_INLINE Mask<Real> ahead(std::size_t k) const {
    const std::size_t all = partners_[0].size;
    // If two leaves are all/2 apart, each is ahead of the other; only the earlier leaf finds their
    // pairs.
    const bool even_and_late = all % 2 == 0 && leaf_ >= all / 2;
    const auto number = [](std::size_t n) { return Real(static_cast<float>(n)); };
    const Real by = lane_numbers() + (number(k) - number(leaf_));
    const Real cyclic = select(by < Real(0), by + number(all), by);
    return cyclic > Real(0) && cyclic <= number(all / 2 - (even_and_late ? 1 : 0));
  }

  // Finds the leaves in range of a body. `at` is the position of the body relative to the centre of
  // its leaf.
  void select_leaves(const Vec3<float>& at) {
    near_.size = 0;
    near_.reserve(leaves_.size);
    for (std::size_t k = 0; k < leaves_.size; k += Real::width) {
      const auto number = [&](std::size_t n) { return Real::load(&leaves_.numbers[n][k]); };
      const Vec3<Real> to{number(0) - Real(at.x), number(1) - Real(at.y), number(2) - Real(at.z)};
      const auto present = first_lanes<float>(std::min(Real::width, leaves_.size - k));
      const auto is = distance2(to, {number(3), number(4), number(5)}) < Real(listed2_);
      near_.add(Selection(is && present), PackIndex<float>::load(&leaves_.words[k]),
                {to.x, to.y, to.z});
    }
  }

  // Tests the slots of the leaves in range of a body. The loop uses local variables, because the
  // compiler cannot know that storing entries does not change members.
  void scan_near(Found& found) const {
    const float *const x = in_leaf(0), *const y = in_leaf(1), *const z = in_leaf(2);
    const Real listed2(listed2_);
    std::uint32_t* const words = found.words.data();
    float* const distances2 = found.numbers[0].data();
    std::size_t size = found.size;
    for (std::size_t k = 0; k < near_.size; ++k) {
      const std::uint32_t leaf = near_.words[k], first = Neighbour(leaf).slot();
      const Real to_x(near_.numbers[0][k]), to_y(near_.numbers[1][k]), to_z(near_.numbers[2][k]);
      for (std::uint32_t n = 0; n < SlotTree::leaf; n += Real::width) {
        const Real dx = Real::load(x + first + n) + to_x, dy = Real::load(y + first + n) + to_y,
                   dz = Real::load(z + first + n) + to_z, r2 = dx * dx + dy * dy + dz * dz;
        const Selection selected(r2 < listed2);
        selected.store(consecutive(leaf + n), words + size);
        selected.store(r2, distances2 + size);
        size += selected.count();
      }
    }
    found.size = size;
  }

  // Tests the slots after `own`, the body's slot, in the image of its leaf at the distance `to`.
  void scan_later(Neighbour leaf, std::size_t own, const Vec3<float>& to, Found& found) const {
    for (std::uint32_t k = 0; k < SlotTree::leaf; k += Real::width) {
      const auto along = [&](std::size_t d) {
        return Real::load(in_leaf(d) + leaf.slot() + k) + Real(to[d]);
      };
      const Real x = along(0), y = along(1), z = along(2), r2 = x * x + y * y + z * z;
      const Real slots = lane_numbers() + Real(static_cast<float>(k));
      const auto is = slots > Real(static_cast<float>(own)) && r2 < Real(listed2_);
      found.add(Selection(is), consecutive(leaf.word() + k), {r2});
    }
  }
  const float* in_leaf(std::size_t d) const { return job_.tree.in_leaf()[d].data(); }

  const ListJob& job_;
  const BoxLevel& own_;                    // leaves of the body's molecule type
  const std::vector<BoxLevel>& partners_;  // tree of the partners' molecule type
  const std::uint32_t own_first_, partner_first_, chunk_end_;
  const bool same_;
  float listed2_;
  Vec3<float> unit_;

  std::size_t leaf_ = ~std::size_t{0};  // leaf to which the members below belong
  Vec3<std::int32_t> at_;               // centre of the leaf in fixed point
  Vec3<float> half_;
  std::vector<OwnImage> own_images_;
  Nodes nodes_, next_;
  Leaves leaves_;
  Shifts near_;
};

}  // namespace
}  // namespace polhode::POLHODE_LOOPS
