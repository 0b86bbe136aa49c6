// SPDX-License-Identifier: MIT
// The neighbour list: all pairs of bodies whose centres are closer than the interaction range plus
// a skin. Each pair is stored with the periodic image of the partner. The list is valid until a
// centre has moved by half the skin since the last build. While the list is valid, no pair of
// centres comes closer by more than the skin. Rotations do not move centres, so they never
// invalidate the list.
//
// The partners of a body form its row, in whole packs. Each pair is listed once, in the row of the
// body that precedes the other body in the cyclic order of slots. If the last pack of a row would
// be partly empty, the surplus pairs are moved to the rows of the partners, provided that these
// rows come later. Because surplus pairs are moved, nearly all lanes are used. Partners that are
// certain to stay inside the switching distance while the list is valid come first in a row,
// because their pairs need no truncation.
//
// The last parts of a topology may be ghosts of the first parts, in the same order: copies of
// bodies of another list. Ghosts are partners of other bodies and have no rows, so pairs of ghosts
// are not listed. A row has the partners of one molecule type, including its ghosts.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/instruction_set.hpp"
#include "forces/pairs/slot_tree.hpp"
#include "polhode/base/workers.hpp"
#include "polhode/forces/laws/settings.hpp"

namespace polhode {

/// A partner in the neighbour list: slot and periodic image, packed into a single word. The image
/// is a shift by −1, 0 or 1 box edges in each direction, stored in two bits per direction.
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

  /// The periodic image given to padding lanes, which is too far away to interact. Along x, the
  /// distance between two bodies in the box is less than an edge plus the skin. After a shift by
  /// two edges, the distance is more than an edge minus the skin, which exceeds every cutoff range.
  /// The fixed-point distance, which wraps around after four edges, also exceeds every cutoff
  /// range.
  static constexpr Image nowhere{-2, 0, 0};

  /// The bits of a periodic image. The bits of direction d are the two highest bits of word << 2 d.
  static constexpr std::uint32_t bits(const Image& image) {
    const auto two = [](int edges) { return static_cast<std::uint32_t>(edges) & 3u; };
    return two(image.x) << 30 | two(image.y) << 28 | two(image.z) << 26;
  }
  static constexpr std::uint32_t top_bits = 3u << 30;

 private:
  int edges(std::size_t d) const { return static_cast<std::int32_t>(word_ << 2 * d) >> 30; }
  std::uint32_t word_;
};

/// A window of consecutive slots of a molecule type, which starts at `first` and wraps around
/// cyclically.
struct SlotWindow {
  std::uint32_t first = 0, count = 0;
};

/// A unit of work: some slots of a molecule type with their rows.
struct ListChunk {
  struct Row {
    std::uint32_t begin, truncated, end;  ///< indices of entries; pairs from `truncated` on may
                                          ///< need truncation
  };
  std::uint32_t part = 0, first = 0, end = 0;  ///< slots first ≤ s < end
  std::vector<Row> rows;               ///< indexed by [slot − first, partner part − part]
  std::vector<std::uint32_t> entries;  ///< words of Neighbour
  std::uint32_t max_row = 0;           ///< number of entries in the longest row
  std::vector<SlotWindow> windows;     ///< for each part, the slots that occur in this chunk
  const Row& row(std::size_t slot, std::size_t partner_part, std::size_t parts) const {
    return rows[(slot - first) * (parts - part) + (partner_part - part)];
  }
};

/// Ranges of the squared distance between the centres of two molecule types [nm²].
struct PairRange {
  double listed2;  ///< range within which pairs are listed
  double inside2;  ///< range within which pairs stay inside the switching distance while the list
                   ///< is valid
};

/// The part with the ghosts of the bodies of a part; none for a part of ghosts.
constexpr std::optional<std::size_t> ghosts_of(std::size_t part, std::size_t own_parts,
                                               std::size_t parts) {
  return own_parts + part < parts ? std::optional(own_parts + part) : std::nullopt;
}

/// Checks the number of molecules.
/// @throws Error  if there are more molecules than the neighbour list can number
void check_count(const Topology& topology);

/// Checks the lengths of the box edges.
/// @throws Error  if an edge is so long that positions in fixed point are too coarse
void check_edges(const Box& box);

class NeighbourList {
 public:
  /// @param topology     molecules, whose sites determine the extent of each molecule type
  /// @param ghost_parts  number of parts at the end of the topology that are ghosts: none, or as
  ///                     many as other parts
  /// @throws Error       if the box is too small for the cutoff plus the extent of the molecules,
  ///                     or if there are more bodies than the list can address
  NeighbourList(const Topology& topology, const ForceSettings& settings, const Box& box,
                std::size_t ghost_parts = 0);

  /// Sets another box, with the topology and settings of the constructor. The list must be built
  /// again before its next use.
  /// @throws Error  if the box is too small; the list is then unchanged
  void set_box(const Topology& topology, const ForceSettings& settings, const Box& box);

  /// Rebuilds the neighbour list from the positions, with rows in packs of `width` pairs.
  /// @throws RunError  if a position is not finite
  void build(const State& state, std::size_t width, Workers& workers = Workers::serial());

  const Box& box() const { return box_; }
  const Slots& slots() const { return slots_; }
  const std::vector<ListChunk>& chunks() const { return chunks_; }
  /// Number of parts of the topology that are not ghosts. Ghosts are in all later parts.
  std::size_t own_parts() const { return own_parts_; }
  /// The part with the ghosts of the bodies of a part, if there are ghosts.
  std::optional<std::size_t> ghosts_of(std::size_t part) const {
    return polhode::ghosts_of(part, own_parts_, slots_.parts.size());
  }

  /// Largest squared displacement since the last build for which the list is still valid [nm²].
  double allowed2() const { return allowed2_; }
  /// The pack width for which the list was built; 0 before the first build in the present box.
  std::size_t width() const { return width_; }

  std::size_t rebuilds() const { return rebuilds_; }
  std::size_t lanes() const;                   ///< number of lanes in all packs, including padding
  double seconds() const { return seconds_; }  ///< wall-clock time spent in build()

 private:
  void reserve_rows();

  Box box_{};
  std::vector<PairRange> ranges_;  // ranges, indexed by [part a, part b]
  double allowed2_ = 0;
  std::size_t own_parts_;  // number of topology parts that are not ghosts
  Slots slots_;
  SlotTree tree_;
  std::vector<ListChunk> chunks_;
  std::size_t width_ = 0;
  std::size_t rebuilds_ = 0;
  double seconds_ = 0;
};

/// The input of the partner search.
struct ListJob {
  const Box& box;
  const Slots& slots;
  const SlotTree& tree;                  ///< tree of the slots
  const std::vector<PairRange>& ranges;  ///< ranges, indexed by [part a, part b]
  std::size_t own_parts;                 ///< number of parts that are not ghosts
  std::size_t width;                     ///< number of pairs per pack
};

POLHODE_DECLARE_LOOPS(
    /// Fills the rows of a chunk.
    void find_partners(const ListJob& job, ListChunk& chunk);)

}  // namespace polhode
