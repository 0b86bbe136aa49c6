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

/// Cells of equal size that fill the box, numbered so that cells near in space are near in number:
/// layers in z are cut into strips several cells wide in x; within a strip, x runs fast and y
/// slowly. A strip and its neighbours then stay in cache during a sweep along y.
struct CellGrid {
  static constexpr std::size_t strip = 12;  ///< width in cells

  Vec3<double> edge{1, 1, 1};  ///< of the box [nm]
  std::array<std::size_t, 3> cells{1, 1, 1};

  CellGrid() = default;
  /// Cells about half as wide as `range` [nm].
  CellGrid(const Box& box, double range);

  std::size_t size() const { return cells[0] * cells[1] * cells[2]; }
  double width(std::size_t d) const { return edge[d] / static_cast<double>(cells[d]); }
  /// Index of the cell that contains a coordinate in the box.
  std::size_t coordinate(double x, std::size_t d) const {
    const auto c = static_cast<std::size_t>(x * static_cast<double>(cells[d]) / edge[d]);
    return std::min(c, cells[d] - 1);
  }
  std::size_t index(std::size_t x, std::size_t y, std::size_t z) const {
    const std::size_t left = x / strip * strip, width = std::min(strip, cells[0] - left);
    return (z * cells[0] + left) * cells[1] + y * width + (x - left);
  }
  /// Calls visit(from, to) for the pieces of an interval along x whose cells are numbered
  /// consecutively.
  template <class Visit>
  void over_strips(std::size_t from, std::size_t to, const Visit& visit) const {
    for (std::size_t x = from; x <= to; x = x / strip * strip + strip)
      visit(x, std::min(to, x / strip * strip + strip - 1));
  }
};

/// The slots of each molecule type begin at a multiple of this number: whole packs of any width.
inline constexpr std::size_t slot_block = 64;

/// Bodies sorted by cell, molecule type by molecule type. A slot is a position in this order. The
/// slots of a type begin at a multiple of slot_block; unused slots before the next type repeat a
/// body of the type and are ignored.
struct Slots {
  struct Part {
    std::uint32_t first = 0, count = 0;
    std::uint32_t end() const { return first + count; }
  };
  std::vector<Part> parts;
  std::vector<std::uint32_t> body;  ///< index of the body in each slot

  // For each slot, when the list was built:
  Vec3Column built_at;                  ///< q [nm], unwrapped
  Vec3Column place;                     ///< q wrapped into the box [nm]
  std::vector<std::uint32_t> cell_end;  ///< [part, cell]: one past the last slot of the cell

  explicit Slots(const Topology& topology);
  std::size_t size() const { return body.size(); }
  std::uint32_t cell_begin(const CellGrid& grid, std::size_t part, std::size_t cell) const {
    return cell == 0 ? parts[part].first : cell_end[part * grid.size() + cell - 1];
  }

  /// Sorts the bodies again.
  /// @throws RunError  if a position is not finite
  void sort(const State& state, const CellGrid& grid, Workers& workers);

 private:
  std::vector<std::uint32_t> first_body_;  // of each part
  std::vector<std::uint32_t> cell_of_;     // of each body
};

}  // namespace polhode
