// SPDX-License-Identifier: MIT
// What the gather loops keep of a pack of charges while they process the charges one by one.
#pragma once

#include "mesh_positions.hpp"

namespace polhode::POLHODE_LOOPS {
namespace {

// The grid points around one charge: row j of plane k begins at values[row_at[j] + plane_at[k]].
template <class T>
struct GridPoints {
  const T* values;
  const std::ptrdiff_t *row_at, *plane_at;

  GridPoints(const MeshGrid<T>& grid, const std::int32_t (&index)[3][Pack<T>::width],
             std::size_t lane)
      : values(grid.values.data() + index[0][lane]),
        row_at(grid.row_at.data() + index[1][lane]),
        plane_at(grid.plane_at.data() + index[2][lane]) {}
};

// Several kinds of weights of `order` grid points along an edge, for each charge of a pack.
template <class T, std::size_t order, std::size_t kinds>
class ChargeWeights {
 public:
  void set(std::size_t kind, std::size_t k, const Pack<T>& weight) {
    weight.store(values_[kind] + k * Pack<T>::width);
  }
  T operator()(std::size_t kind, std::size_t k, std::size_t lane) const {
    return values_[kind][k * Pack<T>::width + lane];
  }

 private:
  alignas(pack_bytes) T values_[kinds][order * Pack<T>::width];
};

// `runs` sums at the eight points of a row, for each charge of a pack.
template <class T, std::size_t runs>
class RowSums {
 public:
  using Real = Pack<T>;
  static constexpr std::size_t columns =
      (runs * Run<T>::length + Real::width - 1) / Real::width * Real::width;

  T* of(std::size_t lane) { return values_ + lane * columns; }
  // One pack of charges for each number.
  void transpose_to(Real* column) const {
    for (std::size_t c = 0; c < columns; c += Real::width)
      transpose<T>([&](std::size_t lane) { return Real::load(values_ + lane * columns + c); },
                   column + c);
  }

 private:
  alignas(pack_bytes) T values_[Real::width * columns] = {};
};

// The force on a charge from the gradient of the potential, per grid spacing; 0 where no body is.
template <class T>
[[gnu::always_inline]] inline Vec3<Pack<T>> force_of(const Vec3<Pack<T>>& gradient,
                                                     const GatherJob<T>& job, std::size_t site,
                                                     const Mask<Pack<T>>& present) {
  using Real = Pack<T>;
  Vec3<Real> force;
  for (std::size_t d = 0; d < 3; ++d) {
    const double points = static_cast<double>(job.grid.points[d]);
    const Real factor(static_cast<T>(-job.bodies.charges[site] * points / job.box.edge[d]));
    force[d] = select(present, factor * gradient[d], Real());
  }
  return force;
}

}  // namespace
}  // namespace polhode::POLHODE_LOOPS
