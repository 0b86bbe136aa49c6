// SPDX-License-Identifier: MIT
// With FFTW. Its plans are estimated, not measured, so that they are the same in every run.
#include "grid_transform.hpp"

#include <fftw3.h>

#include <mutex>

#include "../../math/fourier_plans.hpp"

namespace polhode {
namespace {

// FFTW's names in both precisions.
template <class T>
struct Library;
template <>
struct Library<double> {
  using Complex = fftw_complex;
  using Plan = fftw_plan;
  static constexpr auto plan = fftw_plan_many_dft;
  static constexpr auto plan_of_reals = fftw_plan_many_dft_r2c;
  static constexpr auto plan_to_reals = fftw_plan_many_dft_c2r;
  static constexpr auto run = fftw_execute_dft;
  static constexpr auto run_of_reals = fftw_execute_dft_r2c;
  static constexpr auto run_to_reals = fftw_execute_dft_c2r;
  static constexpr auto destroy = fftw_destroy_plan;
};
template <>
struct Library<float> {
  using Complex = fftwf_complex;
  using Plan = fftwf_plan;
  static constexpr auto plan = fftwf_plan_many_dft;
  static constexpr auto plan_of_reals = fftwf_plan_many_dft_r2c;
  static constexpr auto plan_to_reals = fftwf_plan_many_dft_c2r;
  static constexpr auto run = fftwf_execute_dft;
  static constexpr auto run_of_reals = fftwf_execute_dft_r2c;
  static constexpr auto run_to_reals = fftwf_execute_dft_c2r;
  static constexpr auto destroy = fftwf_destroy_plan;
};

template <class T>
typename Library<T>::Complex* modes_at(T* p) {
  return reinterpret_cast<typename Library<T>::Complex*>(p);
}

}  // namespace

template <class T>
struct GridTransform<T>::Plans {
  using Plan = typename Library<T>::Plan;
  Plan rows, rows_back;        // along x, in place
  Plan along_y, along_y_back;  // from a plane of the grid to its coefficients
  Plan along_z, along_z_back;  // from these to the scratch space of a task

  Plans(const MeshGrid<T>& grid, T* at, std::size_t row, std::size_t plane, T* modes) {
    const auto whole = [](std::size_t n) { return static_cast<int>(n); };
    const int nx = whole(grid.points[0]), ny = whole(grid.points[1]), nz = whole(grid.points[2]);
    const int grid_row = whole(grid.row), half = grid_row / 2, mode_row = whole(row / 2);
    const int mode_plane = whole(plane / 2);
    Column<T> own(row * grid.points[2]);
    auto *const g = modes_at(at), *const w = modes_at(modes), *const o = modes_at(own.data());
    const std::lock_guard lock(fourier_planning());
    using L = Library<T>;
    constexpr int forward = FFTW_FORWARD, backward = FFTW_BACKWARD;
    constexpr unsigned how = FFTW_ESTIMATE;
    rows = L::plan_of_reals(1, &nx, ny, at, nullptr, 1, grid_row, g, nullptr, 1, half, how);
    rows_back = L::plan_to_reals(1, &nx, ny, g, nullptr, 1, half, at, nullptr, 1, grid_row, how);
    const int modes_x = nx / 2 + 1;
    along_y = L::plan(1, &ny, modes_x, g, nullptr, half, 1, w, nullptr, mode_row, 1, forward, how);
    along_y_back =
        L::plan(1, &ny, modes_x, w, nullptr, mode_row, 1, g, nullptr, half, 1, backward, how);
    along_z =
        L::plan(1, &nz, mode_row, w, nullptr, mode_plane, 1, o, nullptr, mode_row, 1, forward, how);
    along_z_back = L::plan(1, &nz, mode_row, o, nullptr, mode_row, 1, w, nullptr, mode_plane, 1,
                           backward, how);
  }
  ~Plans() {
    const std::lock_guard lock(fourier_planning());
    for (const Plan plan : {rows, rows_back, along_y, along_y_back, along_z, along_z_back})
      Library<T>::destroy(plan);
  }
};

template <class T>
GridTransform<T>::GridTransform(MeshGrid<T>& grid)
    : grid_(grid),
      plans_(std::make_unique<Plans>(grid, grid.values.data(), row_, plane_, modes_.data())) {}

template <class T>
GridTransform<T>::~GridTransform() = default;

template <class T>
void GridTransform<T>::plane(std::size_t z) {
  T* const at = &grid_.values[z * grid_.plane];
  Library<T>::run_of_reals(plans_->rows, at, modes_at(at));
  Library<T>::run(plans_->along_y, modes_at(at), modes_at(&modes_[z * plane_]));
}

template <class T>
void GridTransform<T>::columns(std::size_t y, T* modes) {
  Library<T>::run(plans_->along_z, modes_at(&modes_[y * row_]), modes_at(modes));
}

template <class T>
void GridTransform<T>::columns_back(std::size_t y, T* modes) {
  Library<T>::run(plans_->along_z_back, modes_at(modes), modes_at(&modes_[y * row_]));
}

template <class T>
void GridTransform<T>::plane_back(std::size_t z) {
  T* const at = &grid_.values[z * grid_.plane];
  Library<T>::run(plans_->along_y_back, modes_at(&modes_[z * plane_]), modes_at(at));
  Library<T>::run_to_reals(plans_->rows_back, modes_at(at), at);
}

template class GridTransform<double>;
template class GridTransform<float>;

}  // namespace polhode
