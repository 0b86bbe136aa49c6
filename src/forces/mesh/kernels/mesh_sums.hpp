// SPDX-License-Identifier: MIT
// Sums over the tiles around each charge of a pack, and the forces on the charges.
#pragma once

#include "mesh_tiles.hpp"
#include "polhode/base/always_inline.hpp"

namespace polhode::POLHODE_LOOPS {
namespace {

// Vectors of packs to be summed over the elements of each pack. Each charge of a pack has its own
// vector.
template <class T, std::size_t vectors>
class TileSums {
 public:
  using Real = Pack<T>;

  void set(std::size_t vector, std::size_t lane, const Vec3<Real>& tile) {
    for (std::size_t d = 0; d < 3; ++d) tile[d].store(values_[vector][d] + lane * Real::width);
  }
  // The sums of the vectors; lane i contains the sum for charge i.
  Vec3<Real> operator()(std::size_t vector) const {
    Vec3<Real> sum;
    for (std::size_t d = 0; d < 3; ++d) {
      Real column[Real::width];
      transpose<T>(
          [&](std::size_t lane) { return Real::load(values_[vector][d] + lane * Real::width); },
          column);
      for (std::size_t length = Real::width; length > 1; length /= 2)
        for (std::size_t k = 0; k < length / 2; ++k) column[k] += column[k + length / 2];
      sum[d] = column[0];
    }
    return sum;
  }

 private:
  alignas(pack_bytes) T values_[vectors][3][Real::width * Real::width];
};

// The force on a charge, computed from the potential gradient per grid spacing. The force is 0 for
// slots without a body.
template <class T>
POLHODE_INLINE inline Vec3<Pack<T>> force_of(const Vec3<Pack<T>>& gradient, const GatherJob<T>& job,
                                             std::size_t site, const Mask<Pack<T>>& present) {
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
