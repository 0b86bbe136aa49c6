// SPDX-License-Identifier: MIT
// Fourier transforms of a MeshGrid in both directions, in pieces that tasks can share. FFTW's plans
// are estimated, not measured, so that they are the same in every run.
#pragma once

#include <memory>

#include "polhode/forces/mesh/mesh_loops.hpp"

namespace polhode {

/// Transforms of the rows and columns of a grid. Waves are stored as [z][y][x], real and imaginary
/// parts alternating, k_x ≥ 0 only, rows padded with zeros to whole packs.
template <class T>
class GridTransform {
 public:
  explicit GridTransform(MeshGrid<T>& grid);
  ~GridTransform();
  GridTransform(const GridTransform&) = delete;
  GridTransform& operator=(const GridTransform&) = delete;

  /// Numbers per row of waves.
  std::size_t row() const { return row_; }

  /// Transforms plane z of the grid along x and y. The plane is overwritten.
  void plane(std::size_t z);
  /// Transforms the waves of one y along z into `waves`, row after row.
  void columns(std::size_t y, T* waves);
  /// The inverse, not normalised: forward and back multiplies by the number of points.
  void columns_back(std::size_t y, T* waves);
  void plane_back(std::size_t z);

 private:
  struct Plans;
  MeshGrid<T>& grid_;
  std::size_t row_, plane_;  // strides of rows and planes, in numbers
  Column<T> waves_;
  std::unique_ptr<Plans> plans_;
};

}  // namespace polhode
