// SPDX-License-Identifier: MIT
// The free rotation by the recursive method for a fixed time step [vanzon2007b], without elliptic
// integrals of the third kind or theta functions.
#pragma once

#include <array>
#include <cmath>

#include "polhode/rotor/free_rotor.hpp"

namespace polhode {

namespace recursive {

inline constexpr std::size_t max_terms = 14;
using Series = std::array<double, max_terms>;

/// Computes the Taylor coefficients of φ'(s) h about the time at which the angular momentum is L.
/// Here s is the time in units of the step h. Euler's equations determine the derivatives. φ' = |L|
/// (L_i²/J_i + L_j²/J_j)/(L_i² + L_j²) is a quotient of two series, with i and j perpendicular to
/// `axis`.
inline Series angle_rate(const Vec3<double>& J, const Vec3<double>& L, double norm_L,
                         std::size_t axis, double h) {
  std::array<Vec3<double>, max_terms> l;
  l[0] = L;
  for (std::size_t n = 0; n + 1 < max_terms; ++n) {
    Vec3<double> rate;
    for (std::size_t k = 0; k <= n; ++k) {
      const Vec3<double>& w = l[n - k];
      rate += cross(l[k], {w.x / J.x, w.y / J.y, w.z / J.z});
    }
    l[n + 1] = rate * (h / static_cast<double>(n + 1));
  }
  const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
  const double unit = 1 / std::max(std::abs(L[i]), std::abs(L[j]));  // the squares might underflow
  Series rate;
  std::array<double, max_terms> across;
  for (std::size_t n = 0; n < max_terms; ++n) {
    double square_i = 0, square_j = 0;
    for (std::size_t k = 0; k <= n; ++k) {
      square_i += (l[k][i] * unit) * (l[n - k][i] * unit);
      square_j += (l[k][j] * unit) * (l[n - k][j] * unit);
    }
    across[n] = square_i + square_j;
    rate[n] = norm_L * h * (square_i / J[i] + square_j / J[j]);
    for (std::size_t k = 0; k < n; ++k) rate[n] -= rate[k] * across[n - k];
    rate[n] /= across[0];
  }
  return rate;
}

/// Integrates a function from 0 to 1 by two-point Hermite quadrature Σ c_nk [f^{(k)}(0) + (−1)ᵏ
/// f^{(k)}(1)], given its Taylor coefficients at 0 and 1. The error is O(h^{2n+3}); the order n
/// increases until the sum converges.
inline double hermite_quadrature(const Series& from, const Series& to) {
  double sum = 0.5 * (from[0] + to[0]), change = std::abs(sum);
  for (std::size_t n = 1; n < max_terms; ++n) {
    double weight = 0.5, next = 0;  // weight is c_nk k!
    for (std::size_t k = 0; k <= n; ++k) {
      next += weight * (k % 2 == 0 ? from[k] + to[k] : from[k] - to[k]);
      weight *=
          static_cast<double>((k + 1) * (n - k)) / static_cast<double>((k + 2) * (2 * n + 1 - k));
    }
    const double last_change = change;
    change = std::abs(next - sum);
    sum = next;
    if (change <= 1e-16 * std::abs(sum) || (n > 4 && change >= last_change)) break;
  }
  return sum;
}

}  // namespace recursive

/// Computes the free rotation by the recursive method: L by the addition theorem, and the angle
/// about L by two-point Hermite quadrature. The method is intended for steps with |ω t| ≤ 0.5.
/// Longer times are divided into such steps. Every L is computed from the initial L, so its errors
/// do not accumulate. Angles are added by compensated (Kahan) summation. For a million steps or
/// more, the closed form is used instead.
///
/// @param J, L, t  as for closed_rotation()
/// @return         as for closed_rotation(), with the same accuracy
/// @cost           about 2 µs per step
/// @source         vanzon2007b, Sec. IV; tests/unit/rotor_truth_test.cpp
inline FreeRotation recursive_rotation(const Vec3<double>& J, const Vec3<double>& L, double t) {
  const ScaledTop top(J, L, t);
  const bool linear = J.x == 0 || J.y == 0 || J.z == 0;
  if (linear || Orbit::is_stationary(top)) return closed_rotation(J, L, t);

  const Orbit orbit(top);
  const std::size_t axis = PrecessionAngle(orbit).axis;
  // largest |ω| on the orbit, plus the rate p at which L circles the axis z
  const double rate = orbit.p + std::hypot(orbit.Ax / top.J[orbit.x], orbit.Ay / top.J[orbit.y],
                                           orbit.Az / top.J[orbit.z]);
  const double count = std::max(1.0, std::ceil(std::abs(top.t) * rate / 0.5));
  if (!(count <= 1e6)) return closed_rotation(J, L, t);

  const double h = top.t / count;
  recursive::Series from = recursive::angle_rate(top.J, top.L, orbit.norm_L(), axis, h);
  Vec3<double> later = top.L;
  double phi = 0, lost = 0;
  for (double k = 1; k <= count; ++k) {
    later = orbit.L_at(orbit.at(orbit.elapsed(k == count ? top.t : k * h)));
    const recursive::Series to = recursive::angle_rate(top.J, later, orbit.norm_L(), axis, h);
    const double part = recursive::hermite_quadrature(from, to) - lost;
    const double sum = phi + part;
    lost = (sum - phi) - part;  // Kahan summation, because 20000 plain additions would lose 100 ε
    phi = sum;
    from = to;
  }
  return {precession({top.L, axis}, {later, axis}, phi),
          top.in_units_of_caller(later * (orbit.norm_L() / std::hypot(later.x, later.y, later.z)))};
}

}  // namespace polhode
