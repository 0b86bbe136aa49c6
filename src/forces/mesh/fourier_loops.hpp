// SPDX-License-Identifier: MIT
// Fourier transforms of a grid in tiles, by pocketfft with packs as numbers. Each lane of the packs
// belongs to a different series. A pack holds one number of each series. Between the transforms
// along different edges, only tiles are transposed.
#pragma once

#include <cstddef>

#include "base/instruction_set.hpp"
#include "forces/mesh/mesh_grid.hpp"
#include "math/pocketfft.hpp"

namespace polhode {

/// Coefficients of a grid after the Fourier transforms along x and z. A column of coefficients is a
/// series of packs along y, with alternating real and imaginary parts. A pack has `tile.rows`
/// consecutive k_x and `tile.columns` consecutive k_z ≥ 0. Before the transform along y, tiles are
/// transposed (Tile::transpose_rows).
template <class T>
struct MeshModes {
  std::array<std::size_t, 3> points{};
  MeshTile tile;
  std::size_t column = 0;  ///< distance in memory between successive columns, in numbers
  Column<T> values;

  MeshModes() = default;
  explicit MeshModes(const MeshGrid<T>& grid)
      : points(grid.points),
        tile(grid.tile),
        column(odd_lines<T>(2 * points[1] * tile.size())),
        values(columns() * column) {}
  std::size_t columns_x() const { return points[0] / tile.rows; }
  std::size_t columns_z() const { return (points[2] / 2 + tile.columns) / tile.columns; }
  std::size_t columns() const { return columns_x() * columns_z(); }
  /// Index of the column for group x of k_x and group z of k_z.
  std::size_t index(std::size_t x, std::size_t z) const { return z * columns_x() + x; }
  /// Indices of k_x and k_z of a lane of a column. The index of k_z may be above half the number of
  /// grid points.
  std::array<std::size_t, 2> wave(std::size_t column, std::size_t lane) const {
    return {column % columns_x() * tile.rows + lane / tile.columns,
            column / columns_x() * tile.columns + lane % tile.columns};
  }
};

/// A row of stacks, to be transformed along z and x.
template <class T>
struct FourierRowJob {
  const pocketfft::detail::rfftp<T>& along_z;
  const pocketfft::detail::cfftp<T>& along_x;
  MeshGrid<T>& grid;
  std::size_t row;
  MeshModes<T>& modes;
};

/// A column of coefficients, to be transformed along y, multiplied, and transformed back.
template <class T>
struct ConvolveJob {
  const pocketfft::detail::cfftp<T>& along_y;
  T* modes;
  std::size_t length;         ///< points along y
  const T* influence;         ///< factor G: a pack of factors for each k_y ≥ 0
  const T* slope;             ///< factor H in virial = ½ Σ |S|² (G + H k ⊗ k)
  const double *ky, *odd_ky;  ///< wave numbers of each k_y
};

/// Sums of G |S|², and of H |S|² times 1, odd k_y and k_y², over the k_y of a column, lane by lane.
struct ModeSums {
  static constexpr std::size_t lanes = pack_bytes / sizeof(float);
  alignas(pack_bytes) double energy[lanes], slope[lanes], slope_y[lanes], slope_yy[lanes];
};

POLHODE_DECLARE_LOOPS(
    /// Transforms rows of stacks along z and x by Σ exp(−2πi (k_x x/n_x + k_z z/n_z)). The overhang
    /// of the grid is added before the transform.
    void rows_to_modes(const FourierRowJob<double>& job);
    void rows_to_modes(const FourierRowJob<float>& job);
    /// Transforms coefficients back to rows of stacks, including the overhang. The result is the
    /// inverse transform times n_x n_z.
    void modes_to_rows(const FourierRowJob<double>& job);
    void modes_to_rows(const FourierRowJob<float>& job);
    /// Multiplies coefficients by the influence function. If `sums` is given, also sums the
    /// energies.
    void convolve(const ConvolveJob<double>& job, ModeSums* sums);
    void convolve(const ConvolveJob<float>& job, ModeSums* sums);)

}  // namespace polhode
