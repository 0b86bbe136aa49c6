// SPDX-License-Identifier: MIT
// NO_SQUISH, the second-order rotation step of most molecular dynamics programs, included only for
// comparison.
#pragma once

#include <cmath>

#include "polhode/rotor/scaled_top.hpp"
#include "polhode/rotor/small_angle.hpp"

namespace polhode {

/// Computes sin and cos for |x| ≤ 0.3 by Taylor series with a truncation error below 3e-17. Packs
/// use this function.
template <class Real>
SineCosine<Real> small_sine_cosine(Real x) {
  const SineCosine<Real> f = taylor_sine_cosine<5, 6>(x * x);
  return {x * f.sine, f.cosine};
}

/// Approximates the free rotation over a step t by e^{zt/2} e^{yt/2} e^{xt} e^{yt/2} e^{zt/2}, for
/// a quaternion q and its conjugate momentum p = 2 q (0, L). Each factor rotates q and p by an
/// angle about axis k [miller2002, Eq. 2.19 and Sec. II C].
///
/// @param sine_cosine  function that returns sin and cos of half the angle ω_k t
template <class Real, class Function>
void no_squish_step(Quaternion<Real>& q, Quaternion<Real>& p, const Vec3<Real>& inverse_J, Real t,
                    const Function& sine_cosine) {
  // P_k a = a (0, e_k), the permutations of [miller2002]
  const auto Px = [](const Quaternion<Real>& a) { return Quaternion<Real>{-a.x, a.w, a.z, -a.y}; };
  const auto Py = [](const Quaternion<Real>& a) { return Quaternion<Real>{-a.y, -a.z, a.w, a.x}; };
  const auto Pz = [](const Quaternion<Real>& a) { return Quaternion<Real>{-a.z, a.y, -a.x, a.w}; };
  const auto turn = [&](const auto& permuted, Real quarter_time_over_J) {
    const Quaternion<Real> Pq = permuted(q), Pp = permuted(p);
    const Real along = p.w * Pq.w + p.x * Pq.x + p.y * Pq.y + p.z * Pq.z;  // 2 L_k
    const SineCosine<Real> f = sine_cosine(quarter_time_over_J * along);
    const auto rotate = [&](const Quaternion<Real>& a, const Quaternion<Real>& Pa) {
      return Quaternion<Real>{f.cosine * a.w + f.sine * Pa.w, f.cosine * a.x + f.sine * Pa.x,
                              f.cosine * a.y + f.sine * Pa.y, f.cosine * a.z + f.sine * Pa.z};
    };
    q = rotate(q, Pq);
    p = rotate(p, Pp);
  };
  const Vec3<Real> half = inverse_J * (Real(0.125f) * t);
  turn(Pz, half.z);
  turn(Py, half.y);
  turn(Px, Real(2) * half.x);
  turn(Py, half.y);
  turn(Pz, half.z);
}

/// Performs one NO_SQUISH step of the free rotation. The NO_SQUISH step is the same map as
/// symmetric_product_rotation(), written for quaternions.
///
/// @param J, L, t  as for closed_rotation()
/// @source miller2002
inline FreeRotation no_squish_rotation(const Vec3<double>& J, const Vec3<double>& L, double t) {
  const ScaledTop top(J, L, t);
  Quaternion<double> q, p{0, 2 * top.L.x, 2 * top.L.y, 2 * top.L.z};
  no_squish_step(q, p, top.inverse_J(), top.t, [](double x) {
    return SineCosine<double>{std::sin(x), std::cos(x)};
  });
  const Vec3<double> twice_L = (conjugate(q) * p).vector();
  return {normalized(q), top.in_units_of_caller(0.5 * twice_L)};
}

}  // namespace polhode
