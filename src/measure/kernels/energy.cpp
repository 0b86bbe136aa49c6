// SPDX-License-Identifier: MIT
// The sums of kinetic energies over packs of bodies.
#include <algorithm>

#include "base/pack.hpp"
#include "base/pack_column.hpp"
#include "measure/kinetic_sums.hpp"
#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode::POLHODE_LOOPS {

using Real = Pack<double>;

/// Computes sums over the bodies first ≤ i < end, where `first` is the start of a pack.
KineticSums kinetic_sums(const State& state, const Bodies& bodies, std::size_t first,
                         std::size_t end) {
  Real translation(0), mass(0);
  Vec3<Real> rotation{Real(0), Real(0), Real(0)}, momentum = rotation;
  for (std::size_t i = first; i < end; i += Real::width) {
    const auto here = first_lanes<double>(std::min(Real::width, end - i));  // excludes the padding
    const auto without_padding = [&](Real term) { return select(here, term, Real(0)); };
    const Vec3<Real> L =
        to_body(load_pack<Real>(state.orientation, i), load_pack<Real>(state.ell, i));
    const Vec3<Real> inverse_J = load_pack<Real>(bodies.inverse_J, i);
    const Vec3<Real> p = load_pack<Real>(state.p, i);
    translation += without_padding(norm2(p) * Real::load(&bodies.inverse_m[i]));
    momentum += Vec3<Real>{without_padding(p.x), without_padding(p.y), without_padding(p.z)};
    mass += without_padding(Real::load(&bodies.m[i]));
    rotation.x += without_padding(L.x * L.x * inverse_J.x);
    rotation.y += without_padding(L.y * L.y * inverse_J.y);
    rotation.z += without_padding(L.z * L.z * inverse_J.z);
  }
  return {sum(translation) / 2,
          {sum(rotation.x) / 2, sum(rotation.y) / 2, sum(rotation.z) / 2},
          {sum(momentum.x), sum(momentum.y), sum(momentum.z)},
          sum(mass)};
}

}  // namespace polhode::POLHODE_LOOPS
