// SPDX-License-Identifier: MIT
// The Fourier transform of a MeshGrid and back, in pieces that tasks can share. Plans are
// estimated, not measured, so that they do not vary from run to run.
#pragma once

#include <memory>

#include "polhode/forces/mesh_loops.hpp"

namespace polhode {

/// Transforms of the rows and columns of a grid. Waves are stored as [z][y][x], real and imaginary
/// parts in turn, k_x ≥ 0 alone, rows padded with zeros to whole packs.
template <class T>
class GridTransform {
 public:
  explicit GridTransform(MeshGrid<T>& grid);
  ~GridTransform();
  GridTransform(const GridTransform&) = delete;
  GridTransform& operator=(const GridTransform&) = delete;

  /// Numbers in a row of waves.
  std::size_t row() const { return row_; }

  /// Plane z of the grid along x and y. The grid's plane is overwritten.
  void plane(std::size_t z);
  /// The waves of one y along z, to `waves`: rows one after the other.
  void columns(std::size_t y, T* waves);
  /// The way back, without a factor: there and back multiplies by the number of points.
  void columns_back(std::size_t y, T* waves);
  void plane_back(std::size_t z);

 private:
  struct Plans;
  MeshGrid<T>& grid_;
  std::size_t row_, plane_;  // numbers from one to the next
  Column<T> waves_;
  std::unique_ptr<Plans> plans_;
};

}  // namespace polhode
