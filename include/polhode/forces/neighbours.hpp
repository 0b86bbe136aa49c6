// SPDX-License-Identifier: MIT
// The neighbour list: all pairs of bodies, with the image meant, whose centres are closer than the
// reach of their interaction plus a skin. It holds while no centre has moved by half the skin since
// it was built: two centres then come closer by less than the skin, and turning a body does not
// move its centre.
//
// A body's partners stand in a row, in whole packs, and every pair stands in one row: that of the
// body from which the other is ahead in the cyclic order of slots. A row that would leave a pack
// part empty hands its last pairs to rows of partners that come later, so that nearly all lanes are
// used. Partners that are closer than where any switch begins, whatever the motion within the skin,
// come first in a row: their pairs do not end.
#pragma once

#include <cstdint>
#include <vector>

#include "polhode/base/target.hpp"
#include "polhode/base/workers.hpp"
#include "polhode/forces/cells.hpp"
#include "polhode/forces/settings.hpp"

namespace polhode {

/// A partner in the list: its slot, and the image meant, in one word. An image is some edges of the
/// box along each direction: −1, 0 or 1, in two bits each.
class Neighbour {
 public:
  using Image = Vec3<int>;
  static constexpr std::uint32_t slot_bits = 26;
  static constexpr std::uint32_t slot_mask = (1u << slot_bits) - 1;

  Neighbour(std::uint32_t slot, const Image& image) : word_(slot | bits(image)) {}
  explicit Neighbour(std::uint32_t word) : word_(word) {}
  std::uint32_t word() const { return word_; }
  std::uint32_t slot() const { return word_ & slot_mask; }
  Image image() const { return {edges(0), edges(1), edges(2)}; }

  /// An image for what fills up a pack, so far away that nothing acts: two bodies in the box are
  /// less than an edge and a skin apart along x. Two edges on, they are farther apart than an edge
  /// less the skin, in fixed point, too, where four edges are none; no pair reaches that far.
  static constexpr Image nowhere{-2, 0, 0};

  /// The image's part of a word; that of direction d fills the two highest bits of word << 2 d.
  static constexpr std::uint32_t bits(const Image& image) {
    const auto two = [](int edges) { return static_cast<std::uint32_t>(edges) & 3u; };
    return two(image.x) << 30 | two(image.y) << 28 | two(image.z) << 26;
  }
  static constexpr std::uint32_t highest_bits = 3u << 30;

 private:
  int edges(std::size_t d) const { return static_cast<std::int32_t>(word_ << 2 * d) >> 30; }
  std::uint32_t word_;
};

/// The slots of one molecule type from `first` on, cyclically.
struct SlotWindow {
  std::uint32_t first = 0, count = 0;
};

/// Some slots of one molecule type with their rows, and the unit of work.
struct ListChunk {
  struct Row {
    std::uint32_t begin, ending, end;  ///< entries; from `ending` on the pairs may end
  };
  std::uint32_t part = 0, first = 0, end = 0;  ///< slots first ≤ s < end
  std::vector<Row> rows;                       ///< [slot − first, partner part − part]
  std::vector<std::uint32_t> entries;          ///< words of Neighbour
  std::uint32_t longest_row = 0;               ///< entries of the longest row
  std::vector<SlotWindow> windows;             ///< of each part: slots that occur here
  const Row& row(std::size_t slot, std::size_t partner_part, std::size_t parts) const {
    return rows[(slot - first) * (parts - part) + (partner_part - part)];
  }
};

/// Ranges of the distance between the centres of two molecule types [nm²].
struct PairRange {
  double listed2;  ///< in the list
  double whole2;   ///< certainly closer than where any switch begins, while the list holds
};

class NeighbourList {
 public:
  /// @param topology  sets how far the sites of each molecule type reach from its centre
  /// @throws Error    if the box is too small for the cutoff and the reach of the molecules, or has
  ///                  more bodies than the list can number
  NeighbourList(const Topology& topology, const ForceSettings& settings, const Box& box);

  /// Lists all pairs anew, in packs of `width`.
  /// @throws RunError  if a position is not finite
  void build(const State& state, std::size_t width, Workers& workers = Workers::serial());

  const Box& box() const { return box_; }
  const Slots& slots() const { return slots_; }
  const std::vector<ListChunk>& chunks() const { return chunks_; }

  /// The square of the displacement since the last build at which the guarantee ends [nm²].
  double allowed2() const { return allowed2_; }
  /// The width of packs that it was built for; 0 before the first build.
  std::size_t width() const { return width_; }

  std::size_t rebuilds() const { return rebuilds_; }
  std::size_t lanes() const;                   ///< of all packs
  double seconds() const { return seconds_; }  ///< spent in build(), wall-clock

 private:
  Box box_;
  std::vector<PairRange> ranges_;  // [part a, part b]
  double range_ = 0;               // the longest listed [nm]
  double allowed2_ = 0;
  CellGrid grid_;
  Slots slots_;
  std::vector<ListChunk> chunks_;
  std::size_t width_ = 0;
  std::size_t rebuilds_ = 0;
  double seconds_ = 0;
};

/// Lattice units per box edge in fixed point: images on both sides fit into 32 bits.
inline constexpr std::int64_t fixed_point_edge = 1 << 30;

/// What the search for partners reads.
struct ListJob {
  const CellGrid& grid;
  const Slots& slots;
  const std::vector<PairRange>& ranges;    ///< [part a, part b]
  const std::vector<std::int32_t>* fixed;  ///< x, y, z of each slot's place, in fixed point
  std::size_t width;                       ///< of packs of pairs
};

POLHODE_DECLARE_LOOPS(
    /// Fills the rows of a chunk.
    void find_partners(const ListJob& job, ListChunk& chunk);)

}  // namespace polhode
