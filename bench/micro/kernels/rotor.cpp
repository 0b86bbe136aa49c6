// SPDX-License-Identifier: MIT
// Benchmark kernels for free rotations of many bodies with SIMD packs: the series and NO_SQUISH.
// Both methods take the orientation and the lab-frame angular momentum, and return the new,
// normalized orientation.
#include "../rotor.hpp"

#include "base/pack.hpp"
#include "base/pack_column.hpp"
#include "polhode/rotor/comparison/no_squish.hpp"
#include "polhode/rotor/series.hpp"

namespace polhode::POLHODE_LOOPS {

using Real = Pack<double>;

void turn_by_series(bench::Tops& tops, double t) {
  for (std::size_t i = 0; i < tops.size(); i += Real::width) {
    const Quaternion<Real> orientation = load_pack<Real>(tops.orientation, i);
    const Vec3<Real> L = to_body(orientation, load_pack<Real>(tops.ell, i));
    const Vec3<Real> inverse_J = load_pack<Real>(tops.inverse_J, i);
    store_pack(normalized(orientation * series_rotation(inverse_J, L, Real(t))), tops.orientation,
               i);
  }
}

void turn_by_no_squish(bench::Tops& tops, double t) {
  for (std::size_t i = 0; i < tops.size(); i += Real::width) {
    Quaternion<Real> q = load_pack<Real>(tops.orientation, i);
    const Vec3<Real> L = to_body(q, load_pack<Real>(tops.ell, i)) * Real(2);
    const Vec3<Real> inverse_J = load_pack<Real>(tops.inverse_J, i);
    Quaternion<Real> p = q * Quaternion<Real>{Real(0), L.x, L.y, L.z};
    no_squish_step(q, p, inverse_J, Real(t), [](Real x) { return small_sine_cosine(x); });
    store_pack(normalized(q), tops.orientation, i);
  }
}

}  // namespace polhode::POLHODE_LOOPS
