// SPDX-License-Identifier: MIT
#include "fourier_loops.hpp"
#include "grid_transform.hpp"

namespace polhode {

template <class T>
struct GridTransform<T>::Plans {
  pocketfft::detail::rfftp<T> x;
  pocketfft::detail::cfftp<T> y, z;
  explicit Plans(const std::array<std::size_t, 3>& points)
      : x(points[0]), y(points[1]), z(points[2]) {}
};

namespace {

/// Length of a row of Fourier coefficients in numbers, in whole packs of the widest kind.
template <class T>
std::size_t numbers(const MeshGrid<T>& grid) {
  return Column<T>::padded(2 * (grid.points[0] / 2 + 1));
}

template <class T>
void transform(const ColumnsJob<T>& job, int sign) {
  POLHODE_CURRENT_OVERLOAD(transform_columns, void (*)(const ColumnsJob<T>&, int))(job, sign);
}

}  // namespace

template <class T>
GridTransform<T>::GridTransform(MeshGrid<T>& grid)
    : grid_(grid), plans_(std::make_unique<Plans>(grid.points)) {}

template <class T>
GridTransform<T>::~GridTransform() = default;

template <class T>
void GridTransform<T>::plane(std::size_t z) {
  const auto [nx, ny, nz] = grid_.points;
  T* const at = &grid_.values[z * grid_.plane];
  POLHODE_CURRENT_OVERLOAD(rows_to_modes, void (*)(const RowsJob<T>&))
  ({plans_->x, at, nx, ny, grid_.row});
  transform<T>({plans_->y, ny, numbers(grid_), at, grid_.row, &modes_[z * plane_], row_}, -1);
}

template <class T>
void GridTransform<T>::columns(std::size_t y, T* modes) {
  transform<T>({plans_->z, grid_.points[2], numbers(grid_), &modes_[y * row_], plane_, modes, row_},
               -1);
}

template <class T>
void GridTransform<T>::columns_back(std::size_t y, T* modes) {
  transform<T>({plans_->z, grid_.points[2], numbers(grid_), modes, row_, &modes_[y * row_], plane_},
               1);
}

template <class T>
void GridTransform<T>::plane_back(std::size_t z) {
  const auto [nx, ny, nz] = grid_.points;
  T* const at = &grid_.values[z * grid_.plane];
  transform<T>({plans_->y, ny, numbers(grid_), &modes_[z * plane_], row_, at, grid_.row}, 1);
  POLHODE_CURRENT_OVERLOAD(modes_to_rows, void (*)(const RowsJob<T>&))
  ({plans_->x, at, nx, ny, grid_.row});
}

template class GridTransform<double>;
template class GridTransform<float>;

}  // namespace polhode
