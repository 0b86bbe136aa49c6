// SPDX-License-Identifier: MIT
// NO_SQUISH, the rotation step of most molecular dynamics programs: second order, for comparison
// only.
#pragma once

#include <array>

#include "polhode/rotor/scaled_top.hpp"

namespace polhode {

/// sin x and cos x.
template <class Real>
struct SineCosine {
  Real sine, cosine;
};

/// sin and cos for |x| ≤ 0.3 by Taylor sums, cut off below 3e-17: what packs use.
template <class Real>
SineCosine<Real> small_sine_cosine(Real x) {
  const Real x2 = x * x;
  const auto sum = [&](const auto& divisors) {  // nested, 1 − x²/d₀ (1 − x²/d₁ (...))
    Real s(1);
    for (std::size_t k = divisors.size(); k-- > 0;)
      s = Real(1) - x2 * constant<Real>(1 / divisors[k]) * s;
    return s;
  };
  constexpr std::array sine{2.0 * 3, 4.0 * 5, 6.0 * 7, 8.0 * 9, 10.0 * 11};
  constexpr std::array cosine{1.0 * 2, 3.0 * 4, 5.0 * 6, 7.0 * 8, 9.0 * 10, 11.0 * 12};
  return {x * sum(sine), sum(cosine)};
}

/// The free rotation of quaternion q and its conjugate momentum p = 2 q (0, L) over a step t:
/// e^{z t/2} e^{y t/2} e^{x t} e^{y t/2} e^{z t/2}, each factor turning both by an angle about axis
/// k (miller2002, Eq. 2.19 and Sec. II C).
///
/// @param sine_cosine  gives sin and cos of half the angle ω_k t
template <class Real, class Function>
void no_squish_step(Quaternion<Real>& q, Quaternion<Real>& p, const Vec3<Real>& inverse_J, Real t,
                    const Function& sine_cosine) {
  // P_k q, the permutations of miller2002: q (0, e_k)
  const auto permuted = [](const Quaternion<Real>& a, std::size_t k) -> Quaternion<Real> {
    if (k == 0) return {-a.x, a.w, a.z, -a.y};
    if (k == 1) return {-a.y, -a.z, a.w, a.x};
    return {-a.z, a.y, -a.x, a.w};
  };
  constexpr std::array<std::size_t, 5> axes{2, 1, 0, 1, 2};
  for (const std::size_t k : axes) {
    const Quaternion<Real> Pq = permuted(q, k), Pp = permuted(p, k);
    const Real along = p.w * Pq.w + p.x * Pq.x + p.y * Pq.y + p.z * Pq.z;  // 2 L_k
    const Real time = k == 0 ? t : Real(0.5f) * t;
    const SineCosine<Real> f = sine_cosine(Real(0.25f) * inverse_J[k] * along * time);
    const auto turned = [&](const Quaternion<Real>& a, const Quaternion<Real>& Pa) {
      return Quaternion<Real>{f.cosine * a.w + f.sine * Pa.w, f.cosine * a.x + f.sine * Pa.x,
                              f.cosine * a.y + f.sine * Pa.y, f.cosine * a.z + f.sine * Pa.z};
    };
    q = turned(q, Pq);
    p = turned(p, Pp);
  }
}

/// The rotation of one NO_SQUISH step; the same map as symmetric_product_rotation, in quaternions.
///
/// @param J, L, t  as for closed_rotation
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
