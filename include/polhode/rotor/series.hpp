// SPDX-License-Identifier: MIT
// The free rotation over one time step, without branches, for numbers and packs alike.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "polhode/base/always_inline.hpp"
#include "polhode/base/quaternion.hpp"

namespace polhode {

namespace series {

/// Coefficients of the function S(τ) = τ Σ s_n with S'² = (1 − P S²)(1 − Q S²), which is Jacobi's
/// sn(√Q τ)/√Q. The term s_n is (−τ²)ⁿ/(2n+1)! times Σ_j a_nj e₁ⁿ⁻²ʲ e₂ʲ with e₁ = P + Q and e₂ = P
/// Q. Each row contains the a_nj of one n, from the recursion of S'' = −e₁ S + 2 e₂ S³ in exact
/// arithmetic.
inline constexpr std::size_t max_sine_order = 10;
// clang-format off
constexpr std::array<std::array<double, 6>, max_sine_order + 1> sine_numerators = {{
    {1},
    {1},
    {1, 12},
    {1, 132},
    {1, 1224, 3024},
    {1, 11064, 132624},
    {1, 99636, 4095792, 4390848},
    {1, 896796, 111810672, 490287168},
    {1, 8071248, 2901537504, 35424905472, 21224560896},
    {1, 72641328, 73688590944, 2134087471872, 4824426168576},
    {1, 653772060, 1854309555360, 117309332937600, 674428567921920, 257991277243392},
}};
// clang-format on

/// The coefficient (−1)ⁿ a_nj/(2n+1)!, multiplied by 1 for S and by 2n+1 for S'.
constexpr double sine_coefficient(std::size_t n, std::size_t j, bool derivative) {
  double c = sine_numerators[n][j];
  for (std::size_t k = 2; k <= 2 * n + 1; ++k) c /= static_cast<double>(k);
  if (derivative) c *= static_cast<double>(2 * n + 1);
  return n % 2 == 0 ? c : -c;
}

/// Evaluates the terms n to `order` that contain e₂ʲ, by Horner's rule in e₁.
template <std::size_t order, bool derivative, std::size_t j, std::size_t n, class Real>
Real sine_row(Real e1) {
  constexpr double number = sine_coefficient(n, j, derivative);
  const Real c = constant<Real>(number);
  if constexpr (n == order)
    return c;
  else
    return sine_row<order, derivative, j, n + 1>(e1) * e1 + c;
}

/// The series S/τ, or S'(τ), to the given order, with e₁ and e₂ in units of 1/τ² and 1/τ⁴.
template <std::size_t order, bool derivative, std::size_t j = 0, class Real>
Real sine(Real e1, Real e2) {
  const Real row = sine_row<order, derivative, j, 2 * j>(e1);
  if constexpr (2 * (j + 1) > order)
    return row;
  else
    return sine<order, derivative, j + 1>(e1, e2) * e2 + row;
}

/// The combination i_x i_z + i_x i_y - i_y i_z = i_x^2 i_y i_z (J_y + J_z - J_x) of inverse
/// moments. One very large inverse moment is multiplied by the difference of the other two, so a
/// needle loses no digits.
template <class Real>
Real triangle(Real x, Real y, Real z) {
  const Mask<Real> ascending = y < z;
  const Real small = select(ascending, y, z), large = select(ascending, z, y);
  return large * (x - small) + x * small;
}

/// Calls f(0), f(1), ..., f(count - 1) with compile-time constants as arguments.
template <std::size_t count, class Function>
constexpr void unroll(const Function& f) {
  [&]<std::size_t... k>(std::index_sequence<k...>) {
    (f(std::integral_constant<std::size_t, k>{}), ...);
  }
  (std::make_index_sequence<count>{});
}

/// Coefficients of the equation of the angle G = X F, multiplied by X: (1 - c1 + c2 - c3) (G + 2 X
/// G') = K3 + K2 G + K1 G^2. The powers of X are part of the coefficients: c_n contains X^n, and
/// element n of each K contains X^(n+1).
template <class Real>
struct AngleEquation {
  std::array<Real, 3> K1, K2, K3;
  Real c1, c2, c3;
};

/// The sum of e and the products K1_j d_a d_b with a + b = n - 2 - j, except the products with
/// d_(n-2).
template <std::size_t n, class Real, std::size_t terms>
POLHODE_INLINE inline Real plus_products(Real e, const std::array<Real, 3>& K1,
                                         const std::array<Real, terms>& d) {
  unroll<3>([&](auto power) {
    constexpr std::size_t j = power, first = j == 0 ? 1 : 0;
    if constexpr (n >= 2 + j + 2 * first) {
      constexpr std::size_t k = n - 2 - j;
      Real pairs(0);
      unroll<(k + 1) / 2 - first>([&](auto a) {
        constexpr std::size_t b = a + first;
        pairs = pairs + d[b] * d[k - b];
      });
      pairs = pairs + pairs;
      if constexpr (k % 2 == 0) pairs = pairs + d[k / 2] * d[k / 2];
      e = e + K1[j] * pairs;
    }
  });
  return e;
}

/// The angle G as the sum of `terms` terms d_n of order X^(n+1): (2n+3) d_n = ((2n+1) c1 + K2_0)
/// d_(n-1) + ... The sum adds the newest terms last, and the coefficients include the division by
/// 2n+3. The chain of dependent operations is therefore only two operations long per term.
template <std::size_t terms, class Real>
POLHODE_INLINE inline Real angle_sum(const AngleEquation<Real>& of) {
  std::array<Real, terms> d;
  Real angle(0);
  unroll<terms>([&](auto count) {
    constexpr std::size_t n = count;
    constexpr auto number = [](std::size_t k) { return constant<Real>(static_cast<double>(k)); };
    const Real divided = Real(1) / number(2 * n + 3);
    Real e(0);
    if constexpr (n < 3) e = of.K3[n];
    e = plus_products<n>(e, of.K1, d);
    if constexpr (n >= 3) e = e + (of.c3 * number(2 * n - 3) + of.K2[2]) * d[n - 3];
    if constexpr (n >= 2) {
      const Real twice_d0 = n == 2 ? d[0] : d[0] + d[0];  // the product d_0 d_0 occurs once
      e = e + (of.K2[1] - of.c2 * number(2 * n - 1) + of.K1[0] * twice_d0) * d[n - 2];
    }
    d[n] = e * divided;
    if constexpr (n >= 1)
      d[n] = d[n] + ((of.c1 * number(2 * n + 1) + of.K2[0]) * divided) * d[n - 1];
    angle = angle + d[n];
  });
  return angle;
}

}  // namespace series

/// The number of series terms, and the largest |omega t| for which this number suffices.
///
/// Let b = |omega t|/2. Mass distributions (J_z <= J_x + J_y, cyclic) have |lambda_k| <= omega_k^2,
/// hence |P|, |Q| <= omega^2, and S is majorised by tan(b) term by term. The truncation error of
/// S/tau after term n is below 2 (2b/pi)^(2n+2), which is 9e-19 for the short and 1e-17 for the
/// long series. The terms d_n of the angle are polynomials in the body's shape and the direction of
/// L. Shapes and directions form a compact set. The truncation errors of the series, 1.7e-17 and
/// 2.8e-17, are from a scan over 10^6 bodies down to J_min/J_max = 1e-6. The scan compared the
/// series with a Taylor series in extended precision. Flat needles that rotate about the middle
/// axis have the largest error. tests/unit/rotor_series_test.cpp repeats part of the scan.
struct SeriesOrder {
  std::size_t sine, angle;  ///< index of the last term of the series of S, and number of terms of
                            ///< the angle
  double radius;            ///< largest |omega t| [1]
};
inline constexpr SeriesOrder short_series{6, 6, 0.15};  ///< truncation error below 3e-17
inline constexpr SeriesOrder long_series{8, 9, 0.3};    ///< truncation error below 3e-17
inline constexpr SeriesOrder float_series{3, 4, 0.3};   ///< truncation error below 3e-8, for float

/// The quaternion of the free rotation over a step, multiplied by some positive number near 1.
///
/// Let tau = t/2, M the angular momentum at tau, and C^2 = 1 - Q S^2, D^2 = 1 - P S^2, E = C D =
/// S'. The addition theorem gives L(t) - L(0) = T s x J^-1 s with s = L(0) + L(t) and a scalar T. A
/// rotation that carries L(t) to L(0) then has a vector part (T J^-1 + delta) s relative to its
/// scalar part, with one scalar delta. This is the discrete top of Moser and Veselov, with moments
/// corrected by delta [mclachlan2005]. Hence
///
///     r ~ (1, (M_x/D)(S i_x + S d), M_y (S i_y + S d), (M_z/C)(S i_z + S d)),   i = J^-1,
///
/// and q' = q (0, omega)/2 becomes a Riccati equation for S d = S^3 F(X), polynomial in X = S^2:
///
///     (1 - P X)(1 - Q X)(1 - y X)(3 F + 2 X F') = K3 + X K2 F + X^2 K1 F^2.
///
/// The recursion below gives the power series of F. There is no division by a difference of
/// moments, by |L| or by a component of L. Spherical, symmetric, linear and resting bodies are
/// therefore not special cases.
///
/// @param inverse_J  inverse principal moments [1/(u nm^2)]; 0 for the vanishing moment of a linear
///                   body. The moments obey the triangle inequality.
/// @param L          body-frame angular momentum [u nm^2/ps]
/// @param t          time [ps], |omega t| <= order.radius; any sign
/// @return           (w, x, y, z) with w > 0; normalize the result, or the product that contains
///   the result
/// @cost             long_series about 330 flops and a division; short_series about 230
/// @accuracy         lane types: float, double; largest error 1 ULP of w in every component
///                   (tests/unit/rotor_series_test.cpp)
/// @source           addition theorem: DLMF 22.8; discrete top: moser1991, mclachlan2005;
///                   derivation: docs/theory-rotor.md
template <SeriesOrder order, class Real>
Quaternion<Real> unnormalized_rotation(const Vec3<Real>& inverse_J, const Vec3<Real>& L, Real t) {
  const Vec3<Real> i = inverse_J * (Real(0.5f) * t);    // from here on, the unit of time is t/2
  const Vec3<Real> A{i.z - i.y, i.x - i.z, i.y - i.x};  // L_x' = A_x L_y L_z, and cyclic
                                                        // permutations
  const Vec3<Real> L2{L.x * L.x, L.y * L.y, L.z * L.z};

  // lambda_y, P = lambda_y - lambda_x and Q = lambda_y - lambda_z, with lambda_x = A_y A_z L_x^2,
  // cyclic; P and Q are invariants.
  const Real Axz = A.x * A.z;
  const Real lambda = Axz * L2.y;
  const Real P = lambda - A.y * A.z * L2.x;
  const Real Q = lambda - A.x * A.y * L2.z;
  const Real S = series::sine<order.sine, false>(P + Q, P * Q);
  const Real E = series::sine<order.sine, true>(P + Q, P * Q);
  const Real X = S * S, SE = S * E;

  // By the addition theorem M_k^2 = L_k^2 + A_k eta.
  const Real denominator = Real(1) - lambda * X;
  const Vec3<Real> rate{A.x * L.y * L.z, A.y * L.z * L.x, A.z * L.x * L.y};  // derivative L'(0)
  const Real h = rate.y * L.z * L.x;
  const Real g = L2.y * (A.z * L2.x + A.x * L2.z);
  const Real eta = (Real(2) * L.x * L.y * L.z * SE + X * ((h + g) + lambda * X * (h - g))) /
                   (denominator * denominator);
  const Vec3<Real> M2{L2.x + A.x * eta, L2.y + A.y * eta, L2.z + A.z * eta};

  // The coefficients of the equation of the angle follow.
  const Vec3<Real> c{series::triangle(i.x, i.y, i.z), series::triangle(i.y, i.z, i.x),
                     series::triangle(i.z, i.x, i.y)};
  const Real PX = P * X, QX = Q * X, yX = Axz * M2.y * X, PQX = PX * QX, sum = PX + QX;
  const auto coefficients = [&](Real x, Real y, Real z) {  // coefficients of x C^2 + y C^2 D^2 + z
                                                           // D^2
    return std::array<Real, 3>{x + y + z, -(QX * (x + y) + PX * (y + z)), PQX * y};
  };
  const Vec3<Real> m{X * i.x * M2.x, X * i.y * M2.y, X * i.z * M2.z};
  const auto K1 = coefficients(m.x, m.y, m.z);
  const auto K2 =
      coefficients(i.x * m.x + c.x * X * M2.x, Real(2) * i.y * m.y, i.z * m.z + c.z * X * M2.z);
  const auto K3 = coefficients(c.x * m.x, c.y * m.y, c.z * m.z);
  const Real angle =
      series::angle_sum<order.angle, Real>({K1, K2, K3, sum + yX, PQX + yX * sum, PQX * yX});

  const Real C2 = Real(1) - QX, D2 = Real(1) - PX;
  return {denominator * E, S * (L.x * C2 + rate.x * SE) * (i.x + angle),
          S * (L.y * C2 * D2 + rate.y * SE) * (i.y + angle),
          S * (L.z * D2 + rate.z * SE) * (i.z + angle)};
}

/// Computes L in the body frame after the rotation r as L - 2 w n x L + 2 n x (n x L). Unlike a
/// product with the matrix of r, this formula has only the round-off of the change of L, which is
/// small. The formula therefore conserves |L| better. In a steady rotation, the round-off error of
/// |r| is the same in every step. With the matrix product, this error would accumulate.
template <class Real>
Vec3<Real> momentum_after(const Quaternion<Real>& r, const Vec3<Real>& L) {
  const Vec3<Real> n = r.vector(), c = cross(n, L);
  return L + Real(2) * (cross(n, c) - r.w * c);
}

/// Computes the free rotation over a step of any size, for numbers and packs. Within its range, a
/// single series is used. Beyond this range, the step is divided into equal sub-steps. The number
/// of sub-steps is the same for all lanes, and the fastest rotation determines it.
///
/// @param inverse_J, L, t  as for the single series, with |omega t| up to about 20 (beyond that,
///   the closed form is cheaper)
/// @return                 as for the single series
/// @source                 tests/unit/rotor_series_test.cpp, tests/unit/drift_test.cpp
template <class Real>
Quaternion<Real> series_rotation(const Vec3<Real>& inverse_J, Vec3<Real> L, Real t) {
  const auto beyond = [&](const Real& time, double radius) {
    const Vec3<Real> angle = scaled(inverse_J, L) * time;
    return any(norm2(angle) > constant<Real>(radius * radius));
  };
  Quaternion<Real> turned{Real(1), Real(0), Real(0), Real(0)};
  bool first = true;
  const auto then = [&](const Quaternion<Real>& r) { return first ? r : turned * r; };
  while (beyond(t, short_series.radius)) {
    Real part = t;
    bool last = true;
    while (beyond(part, long_series.radius)) {
      part = Real(0.5f) * part;
      last = false;
    }
    const Quaternion<Real> r = unnormalized_rotation<long_series>(inverse_J, L, part);
    if (last) return then(r);
    const Quaternion<Real> step = normalized(r);
    turned = then(step);
    first = false;
    L = momentum_after(step, L);
    t = t - part;
  }
  return then(unnormalized_rotation<short_series>(inverse_J, L, t));
}

}  // namespace polhode
