// SPDX-License-Identifier: MIT
// A grid of cells over the box, and the order of bodies by cells: bodies that are neighbours in
// space become neighbours in memory.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "polhode/base/workers.hpp"
#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// Cells of equal size that fill the box, numbered so that consecutive bodies fill compact blocks:
/// columns along z, cut into thin cells, are swept up and down in turn, layer by layer along y,
/// which is also how the points of a mesh are stored.
struct CellGrid {
  static constexpr double block = 16;  ///< bodies in a piece of a column that is as long as wide
  static constexpr double slices = 8;  ///< cells along this piece

  Vec3<double> edge{1, 1, 1};  ///< of the box [nm]
  std::array<std::size_t, 3> cells{1, 1, 1};

  CellGrid() = default;
  /// Cells for a number of bodies, spread over the box.
  CellGrid(const Box& box, std::size_t bodies);

  std::size_t size() const { return cells[0] * cells[1] * cells[2]; }
  double width(std::size_t d) const { return edge[d] / static_cast<double>(cells[d]); }
  /// Index of the cell that contains a coordinate in the box.
  std::size_t coordinate(double x, std::size_t d) const {
    const auto c = static_cast<std::size_t>(x * static_cast<double>(cells[d]) / edge[d]);
    return std::min(c, cells[d] - 1);
  }
  std::size_t index(std::size_t x, std::size_t y, std::size_t z) const {
    const std::size_t column = y * cells[0] + (y % 2 == 0 ? x : cells[0] - 1 - x);
    return column * cells[2] + (column % 2 == 0 ? z : cells[2] - 1 - z);
  }
};

/// The slots of each molecule type begin at a multiple of this number: whole packs of any width.
inline constexpr std::size_t slot_block = 64;

/// Bodies sorted by cell, molecule type by molecule type, each with a grid of its own. A slot is a
/// position in this order. The slots of a type begin at a multiple of slot_block; unused slots
/// before the next type repeat a body of the type and are ignored.
struct Slots {
  struct Part {
    std::uint32_t first = 0, count = 0;
    std::uint32_t end() const { return first + count; }
  };
  std::vector<Part> parts;
  std::vector<std::uint32_t> body;  ///< index of the body in each slot

  // For each slot, when the list was built:
  Vec3Column built_at;  ///< q [nm], unwrapped
  Vec3Column place;     ///< q wrapped into the box [nm]

  explicit Slots(const Topology& topology);
  std::size_t size() const { return body.size(); }
  /// Sorts the bodies again.
  /// @throws RunError  if a position is not finite
  void sort(const State& state, Workers& workers);

 private:
  std::vector<std::uint32_t> first_body_;  // of each part
  std::vector<std::uint32_t> cell_of_;     // of each body
  std::vector<std::uint32_t> cell_end_;    // of the part being sorted
};

}  // namespace polhode
