// SPDX-License-Identifier: MIT
// A grid of cells over the box, and the order of bodies by cells. Bodies in the order of cells are
// close in memory if they are close in space.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "polhode/base/workers.hpp"
#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// Cells of equal size that fill the box, numbered so that consecutive bodies fill compact blocks.
/// Columns of thin cells along z are traversed alternately up and down, layer by layer along y.
/// Mesh points are stored in the same order.
struct CellGrid {
  static constexpr double block = 16;  ///< number of bodies in a cubic piece of a column
  static constexpr double slices = 8;  ///< number of cells in a cubic piece of a column

  Vec3<double> edge{1, 1, 1};  ///< box edges [nm]
  std::array<std::size_t, 3> cells{1, 1, 1};

  CellGrid() = default;
  /// Divides the box into cells for a number of bodies.
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

/// The slots of each molecule type begin at a multiple of `slot_block`, and therefore with a whole
/// pack of any width.
inline constexpr std::size_t slot_block = 64;

/// Number of slots that a task places, or gathers forces for, at once.
inline constexpr std::size_t slots_at_once = 4 * slot_block;

/// Bodies sorted by molecule type and then by cell, where each type has a separate grid of cells. A
/// slot is a position in the sorted order. The slots of a type begin at a multiple of slot_block.
/// Unused slots before the next type repeat a body of the type and are ignored.
struct Slots {
  struct Part {
    std::uint32_t first = 0, count = 0;
    std::uint32_t end() const { return first + count; }
  };
  std::vector<Part> parts;
  std::vector<std::uint32_t> body;  ///< index of the body in each slot

  // Position of the body in each slot at the last build of the neighbour list:
  Vec3Column built_at;  ///< unwrapped position q [nm]
  Vec3Column place;     ///< position q wrapped into the box [nm]

  explicit Slots(const Topology& topology);
  std::size_t size() const { return body.size(); }
  /// Sorts the bodies again.
  /// @throws RunError  if a position is not finite
  void sort(const State& state, Workers& workers);

 private:
  std::vector<std::uint32_t> first_body_;  // first body of each part
  std::vector<std::uint32_t> cell_of_;     // cell of each body
  std::vector<std::uint32_t> cell_end_;    // ends of the cells of the part that is being sorted
};

}  // namespace polhode
