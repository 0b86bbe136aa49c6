// SPDX-License-Identifier: MIT
// The loops of drift and kick over packs of bodies.
#include "polhode/integrate/flows.hpp"

#include "polhode/base/pack.hpp"
#include "polhode/base/pack_column.hpp"
#include "polhode/rotor/series.hpp"

namespace polhode::POLHODE_LOOPS {

using Real = Pack<double>;

void drift(State& state, const Bodies& bodies, double t) {
  for (std::size_t i = 0; i < state.size(); i += Real::width) {
    const Vec3<Real> p = load_pack<Real>(state.p, i);
    const Vec3<Real> q = load_pack<Real>(state.q, i);
    store_pack(q + (Real(t) * Real::load(&bodies.inverse_m[i])) * p, state.q, i);  // q + t p/m

    const Quaternion<Real> attitude = load_pack<Real>(state.attitude, i);
    const Vec3<Real> L = to_body(attitude, load_pack<Real>(state.ell, i));  // L = S ℓ
    const Quaternion<Real> P = rotation_series(load_pack<Real>(bodies.inverse_J, i), L, Real(t));
    store_pack(normalized(attitude * P), state.attitude, i);  // S ← P(t) S
  }
}

void kick(State& state, const Load& load, double t) {
  for (std::size_t i = 0; i < state.size(); i += Real::width) {
    store_pack(load_pack<Real>(state.p, i) + load_pack<Real>(load.f, i) * Real(t), state.p, i);
    store_pack(load_pack<Real>(state.ell, i) + load_pack<Real>(load.tau, i) * Real(t), state.ell,
               i);
  }
}

}  // namespace polhode::POLHODE_LOOPS
