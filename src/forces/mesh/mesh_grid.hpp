// SPDX-License-Identifier: MIT
// Grids over the box, stored in tiles. A tile is a pack of the instruction set in use.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "base/blocks.hpp"
#include "base/instruction_set.hpp"
#include "polhode/base/column.hpp"

namespace polhode {

/// The stride for rows or planes of a given size: an odd number of cache lines. With an even number
/// of lines, the same column of successive rows would map to few sets of the cache.
template <class T>
std::size_t odd_lines(std::size_t numbers) {
  constexpr std::size_t line = pack_bytes / sizeof(T);
  return (blocks(numbers, line) | 1) * line;
}

/// The shape of a tile. A tile is the set of grid points in a pack: `rows` rows along y, each with
/// `columns` points along x, at the same z.
struct MeshTile {
  std::size_t columns = 1, rows = 1;
  std::size_t size() const { return columns * rows; }
  friend bool operator==(const MeshTile&, const MeshTile&) = default;
};

/// Numbers on the points of a grid. Tiles at the same x and y form a stack along z, which is
/// contiguous in memory. Beyond the last plane, a stack repeats its first planes (periodic
/// continuation), so that a spline can be added at any z. Stacks are ordered by x, then by y.
template <class T>
struct MeshGrid {
  std::array<std::size_t, 3> points{};
  MeshTile tile;
  std::size_t overhang = 0;  ///< number of planes beyond the last plane of the box
  std::size_t stack = 0;     ///< distance between stacks along x, in numbers
  std::size_t row = 0;       ///< distance between rows of stacks, in numbers
  Column<T> values;
  /// Offsets in memory: stack_at[x] for the stack at x, and row_at[y] for the row of stacks at y.
  /// Both tables of offsets continue for eleven points beyond the end of the grid.
  std::vector<std::ptrdiff_t> stack_at, row_at;

  MeshGrid() = default;
  MeshGrid(const std::array<std::size_t, 3>& grid_points, const MeshTile& tile_shape,
           std::size_t overhanging_planes);

  std::size_t stacks() const { return points[0] / tile.columns; }
  std::size_t rows() const { return points[1] / tile.rows; }
  /// Whether the grid is larger than a second-level cache, so that prefetching tiles helps.
  bool is_large() const { return values.size() * sizeof(T) > (std::size_t{1} << 20); }
};

/// The numbers of grid points along x and y are multiples of `mesh_multiple`, so that tiles of any
/// shape fill the grid.
inline constexpr std::size_t mesh_multiple = 4;

POLHODE_DECLARE_LOOPS(
    /// The shape of a tile for grids of double and of float.
    MeshTile mesh_tile(const MeshGrid<double>*); MeshTile mesh_tile(const MeshGrid<float>*);)

}  // namespace polhode
