// SPDX-License-Identifier: MIT
// The loops of drift, kick and displacement over packs of bodies. A range of bodies consists of
// whole packs, unless the range ends at the last body.
#include "polhode/integrate/flows.hpp"

#include "base/pack.hpp"
#include "base/pack_column.hpp"
#include "polhode/integrate/rodrigues.hpp"
#include "polhode/rotor/free_rotor.hpp"
#include "polhode/rotor/small_angle.hpp"

namespace polhode::POLHODE_LOOPS {

using Real = Pack<double>;

namespace {

/// Largest rotation angle in one step [rad] that is computed by the series, divided into sub-steps.
/// Larger rotations, which are rare unless the run has blown up, are computed in closed form for
/// each body.
constexpr double max_by_series = 16;

/// The rotations of the bodies of a pack, each computed for a single body.
/// @param rotation  function that returns the rotation for a lane, and for the vector in this lane
Quaternion<Real> lane_by_lane(const Vec3<Real>& v, const auto& rotation) {
  alignas(pack_bytes) double lane[7][Real::width];
  v.x.store(lane[0]);
  v.y.store(lane[1]);
  v.z.store(lane[2]);
  for (std::size_t k = 0; k < Real::width; ++k) {
    const Quaternion<double> r = rotation(k, {lane[0][k], lane[1][k], lane[2][k]});
    lane[3][k] = r.w;
    lane[4][k] = r.x;
    lane[5][k] = r.y;
    lane[6][k] = r.z;
  }
  return {Real::load(lane[3]), Real::load(lane[4]), Real::load(lane[5]), Real::load(lane[6])};
}

Quaternion<Real> closed_rotations(const Vec3Column& J, const Vec3<Real>& L, double t,
                                  std::size_t first) {
  return lane_by_lane(L, [&](std::size_t k, const Vec3<double>& l) {
    return closed_rotation(J[first + k], l, t).rotation;
  });
}

/// Largest half angle for which the series below is accurate to the last digit: x^14/15! and
/// x^14/14! are below 5e-20. Half angles of displacements are about 1e-6.
constexpr double max_half_angle = 0.25;

/// The rotation R(v) by the vector v, from the series of sin and cos. Rotations by larger angles
/// are computed body by body.
Quaternion<Real> rodrigues_pack(const Vec3<Real>& v) {
  const Real y = Real(0.25) * norm2(v);  // half angle squared
  if (any(y > Real(max_half_angle * max_half_angle)))
    return lane_by_lane(v, [](std::size_t, const Vec3<double>& u) { return rodrigues(u); });
  const SineCosine<Real> f = taylor_sine_cosine<6, 6>(y);
  const Real s = Real(0.5) * f.sine;
  return {f.cosine, s * v.x, s * v.y, s * v.z};
}

}  // namespace

void drift(State& state, const Bodies& bodies, double t, std::size_t first, std::size_t end) {
  for (std::size_t i = first; i < end; i += Real::width) {
    const Vec3<Real> p = load_pack<Real>(state.p, i);
    const Vec3<Real> q = load_pack<Real>(state.q, i);
    store_pack(q + (Real(t) * Real::load(&bodies.inverse_m[i])) * p, state.q, i);  // q + t p/m

    const Quaternion<Real> orientation = load_pack<Real>(state.orientation, i);
    const Vec3<Real> inverse_J = load_pack<Real>(bodies.inverse_J, i);
    const Vec3<Real> L = to_body(orientation, load_pack<Real>(state.ell, i));  // L = S ell
    const Real angle2 = norm2(scaled(inverse_J, L)) * Real(t * t);
    const Quaternion<Real> P = any(angle2 > Real(max_by_series * max_by_series))
                                   ? closed_rotations(bodies.J, L, t, i)
                                   : series_rotation(inverse_J, L, Real(t));
    // Rotates the orientation: S <- P(t) S. The product is normalized in every step, so the
    // deviation of |q| from 1 does not grow with the number of steps.
    store_pack(normalized(orientation * P), state.orientation, i);
  }
}

void kick(State& state, const Bodies& bodies, const Load& load, double t, std::size_t first,
          std::size_t end) {
  const Real none(0);
  for (std::size_t i = first; i < end; i += Real::width) {
    store_pack(load_pack<Real>(state.p, i) + load_pack<Real>(load.f, i) * Real(t), state.p, i);
    Vec3<Real> ell = load_pack<Real>(state.ell, i) + load_pack<Real>(load.tau, i) * Real(t);
    const Vec3<Real> inverse_J =
        load_pack<Real>(bodies.inverse_J, i);  // 0 along an axis without inertia
    const Mask<Real> slim = none >= inverse_J.x || none >= inverse_J.y || none >= inverse_J.z;
    if (any(slim)) {
      const Quaternion<Real> orientation = load_pack<Real>(state.orientation, i);
      const Vec3<Real> L = to_body(orientation, ell);  // L = S ell
      const Vec3<Real> clean =
          to_lab(orientation, Vec3<Real>{select(inverse_J.x > none, L.x, none),
                                         select(inverse_J.y > none, L.y, none),
                                         select(inverse_J.z > none, L.z, none)});
      ell = {select(slim, clean.x, ell.x), select(slim, clean.y, ell.y),
             select(slim, clean.z, ell.z)};
    }
    store_pack(ell, state.ell, i);
  }
}

void gradient_direction(const State& state, const Bodies& bodies, const Load& load, Vec3Column& dq,
                        Vec3Column& dtheta, std::size_t first, std::size_t end) {
  for (std::size_t i = first; i < end; i += Real::width) {
    store_pack(Real::load(&bodies.inverse_m[i]) * load_pack<Real>(load.f, i), dq, i);
    const Vec3<Real> torque =
        to_body(load_pack<Real>(state.orientation, i), load_pack<Real>(load.tau, i));  // S tau
    store_pack(scaled(load_pack<Real>(bodies.inverse_J, i), torque), dtheta, i);
  }
}

void displace(State& state, const Bodies& bodies, const Load& load, double c, std::size_t first,
              std::size_t end) {
  for (std::size_t i = first; i < end; i += Real::width) {
    const Real c_over_m = Real(c) * Real::load(&bodies.inverse_m[i]);
    store_pack(load_pack<Real>(state.q, i) + c_over_m * load_pack<Real>(load.f, i), state.q, i);

    const Quaternion<Real> orientation = load_pack<Real>(state.orientation, i);
    const Vec3<Real> torque = to_body(orientation, load_pack<Real>(load.tau, i));  // S tau
    const Vec3<Real> v = Real(c) * scaled(load_pack<Real>(bodies.inverse_J, i), torque);
    store_pack(orientation * rodrigues_pack(v), state.orientation, i);
  }
}

}  // namespace polhode::POLHODE_LOOPS
