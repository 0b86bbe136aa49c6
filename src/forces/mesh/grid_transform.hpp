// SPDX-License-Identifier: MIT
// Fourier transforms of a MeshGrid in both directions, in pieces that tasks can share, with
// pocketfft or FFTW (POLHODE_FFT). The result of a piece does not depend on the task that computes
// it.
#pragma once

#include <memory>

#include "../pairs/cache_lines.hpp"
#include "polhode/forces/mesh/mesh_loops.hpp"

namespace polhode {

/// Transforms of the rows and columns of a grid. Fourier coefficients are stored as [z][y][x], real
/// and imaginary parts alternating, k_x ≥ 0 only, rows padded with zeros to whole packs.
template <class T>
class GridTransform {
 public:
  explicit GridTransform(MeshGrid<T>& grid);
  ~GridTransform();
  GridTransform(const GridTransform&) = delete;
  GridTransform& operator=(const GridTransform&) = delete;

  /// Numbers per row of coefficients.
  std::size_t row() const { return row_; }

  /// Transforms plane z of the grid along x and y. The plane is overwritten.
  void plane(std::size_t z);
  /// Transforms the coefficients of one y along z into `modes`, row after row.
  void columns(std::size_t y, T* modes);
  /// The inverse, not normalized: forward and back multiplies by the number of points.
  void columns_back(std::size_t y, T* modes);
  void plane_back(std::size_t z);

 private:
  struct Plans;
  MeshGrid<T>& grid_;
  // Strides of rows and planes of coefficients, in numbers.
  std::size_t row_ = spread_lines<T>(2 * (grid_.points[0] / 2 + 1));
  std::size_t plane_ = odd_lines<T>(row_ * grid_.points[1]);
  Column<T> modes_{plane_ * grid_.points[2]};
  std::unique_ptr<Plans> plans_;
};

}  // namespace polhode
