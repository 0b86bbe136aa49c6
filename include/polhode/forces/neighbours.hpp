// SPDX-License-Identifier: MIT
// The neighbour list: all pairs of bodies, with the image meant, whose centres are closer than the
// reach of their interaction plus a skin. It holds while no centre has moved by half the skin since
// it was built: two centres then come closer by less than the skin, and turning a body does not
// move its centre.
#pragma once

#include <cstdint>
#include <vector>

#include "polhode/forces/settings.hpp"
#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// A partner in the list: body index and image in one word.
class Neighbour {
 public:
  static constexpr std::uint32_t index_bits = 27;
  static constexpr std::uint32_t index_mask = (1u << index_bits) - 1;

  Neighbour(std::uint32_t body, std::uint32_t image) : word_(body | image << index_bits) {}
  std::uint32_t body() const { return word_ & index_mask; }
  /// 0 to 26; 13 is the box itself.
  std::uint32_t image() const { return word_ >> index_bits; }

 private:
  std::uint32_t word_;
};

/// The displacements of the 27 images of a box [nm], in the order of Neighbour::image().
std::vector<Vec3<double>> image_shifts(const Box& box);

class NeighbourList {
 public:
  /// @param topology  sets how far the sites of each molecule type reach from its centre
  /// @throws Error    if the box is too small for the cutoff and the reach of the molecules, or has
  ///                  more bodies than the list can number
  NeighbourList(const Topology& topology, const ForceSettings& settings, const Box& box);

  /// Positions in the box, for the list: q minus the whole edges that were between q and the box
  /// when the list was built. Rebuilds the list where its guarantee has ended.
  void update(const State& state);

  const Vec3Column& wrapped() const { return wrapped_; }

  /// The partners j > i of body i that belong to a molecule type.
  std::span<const Neighbour> partners(std::size_t i, std::size_t part) const {
    const std::size_t row = i * parts_ + part;
    return {entries_.data() + begin_[row], entries_.data() + begin_[row + 1]};
  }

  /// The longest distance of centres [nm] at which bodies of two types interact, without the skin.
  double reach(std::size_t part_a, std::size_t part_b) const {
    return reach_[part_a * parts_ + part_b];
  }
  std::size_t longest_row() const { return longest_row_; }
  std::size_t rebuilds() const { return rebuilds_; }
  std::size_t pairs() const { return entries_.size(); }
  double seconds() const { return seconds_; }  ///< spent in update(), wall-clock

 private:
  void build(const State& state);

  Box box_;
  std::size_t parts_;
  std::vector<std::size_t> part_;  // of each body
  std::vector<double> reach_;      // [part a, part b]
  std::vector<double> range2_;     // [part a, part b]: (reach of the pair + skin)²
  double range_ = 0;               // the longest of them
  double allowed2_;                // (skin/2)²
  Vec3Column built_at_;            // q when built
  Vec3Column home_;                // the edges between q and the box when built
  Vec3Column wrapped_;
  std::vector<std::size_t> begin_;  // row i·parts + part → first entry
  std::vector<Neighbour> entries_;
  std::vector<std::uint32_t> cell_begin_, cell_of_, in_cell_;  // scratch of build
  std::size_t longest_row_ = 0;
  std::size_t rebuilds_ = 0;
  double seconds_ = 0;
};

}  // namespace polhode
