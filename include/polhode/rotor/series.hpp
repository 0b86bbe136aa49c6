// SPDX-License-Identifier: MIT
// The free rotation over one time step, branch-free, for numbers and packs alike.
#pragma once

#include <array>
#include <cstddef>

#include "polhode/base/quaternion.hpp"

namespace polhode {

namespace series {

/// S(τ) = τ Σ s_n with S'² = (1 − P S²)(1 − Q S²): Jacobi's sn(√Q τ)/√Q. The term s_n is
/// (−τ²)ⁿ/(2n+1)! times Σ_j a_nj e₁ⁿ⁻²ʲ e₂ʲ with e₁ = P + Q, e₂ = P Q; a row below holds a_nj, from the
/// recursion of S'' = −e₁ S + 2 e₂ S³ in exact arithmetic.
inline constexpr std::size_t max_sine_order = 10;
// clang-format off
inline constexpr std::array<std::array<double, 6>, max_sine_order + 1> sine_numerators = {{
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

/// (−1)ⁿ a_nj/(2n+1)!
constexpr double sine_coefficient(std::size_t n, std::size_t j) {
  double c = sine_numerators[n][j];
  for (std::size_t k = 2; k <= 2 * n + 1; ++k) c /= static_cast<double>(k);
  return n % 2 == 0 ? c : -c;
}

/// S/τ and E = S'(τ) to order n, with e₁ and e₂ in units of 1/τ² and 1/τ⁴.
template <class Real>
struct Sine {
  Real S, E;
};
template <std::size_t order, class Real>
Sine<Real> sine(Real e1, Real e2) {
  Real S(0), E(0);
#pragma GCC unroll 8
  for (std::size_t up = 0; up <= order / 2; ++up) {
    const std::size_t j = order / 2 - up;
    Real s(sine_coefficient(order, j));
    Real e(static_cast<double>(2 * order + 1) * sine_coefficient(order, j));
#pragma GCC unroll 16
    for (std::size_t n = order; n-- > 2 * j;) {
      s = s * e1 + Real(sine_coefficient(n, j));
      e = e * e1 + Real(static_cast<double>(2 * n + 1) * sine_coefficient(n, j));
    }
    S = S * e2 + s;
    E = E * e2 + e;
  }
  return {S, E};
}

}  // namespace series

template <std::size_t sine_order = 8, std::size_t angle_order = 7, class Real>
Quaternion<Real> rotation_series(const Vec3<Real>& inverse_J, const Vec3<Real>& L, Real t) {
  const Real half = Real(0.5) * t;
  const Vec3<Real> i = inverse_J * half;  // time in units of t/2 from here on
  const Vec3<Real> A{i.z - i.y, i.x - i.z, i.y - i.x};  // L_x' = A_x L_y L_z, cyclic
  const Vec3<Real> L2{L.x * L.x, L.y * L.y, L.z * L.z};

  // λ_y, P = λ_y − λ_x, Q = λ_y − λ_z with λ_x = A_y A_z L_x², cyclic; P and Q are invariants.
  const Real Axz = A.x * A.z;
  const Real lambda = Axz * L2.y;
  const Real P = lambda - A.y * A.z * L2.x;
  const Real Q = lambda - A.x * A.y * L2.z;
  const auto [S, E] = series::sine<sine_order>(P + Q, P * Q);
  const Real X = S * S;

  // The addition theorem gives L after half the step over the denominator 1 − λ_y S²; there,
  // L_k² = L_k(0)² + A_k η.
  const Real denominator = Real(1) - lambda * X;
  const Vec3<Real> g{A.x * L.y * L.z, A.y * L.z * L.x, A.z * L.x * L.y};  // L'(0)
  const Real h = g.y * L.z * L.x;
  const Real sigma = L2.y * (A.z * L2.x + A.x * L2.z);
  const Real SE = S * E;
  const Real inverse = Real(1) / (denominator * denominator);
  const Real eta =
      (Real(2) * L.x * L.y * L.z * SE + X * ((h + sigma) + lambda * X * (h - sigma))) * inverse;
  const Vec3<Real> M2{L2.x + A.x * eta, L2.y + A.y * eta, L2.z + A.z * eta};
  const Real y = Axz * M2.y;

  // c_x = i_x i_z + i_x i_y − i_y i_z, cyclic
  const Vec3<Real> c{i.x * (i.y + i.z) - i.y * i.z, i.y * (i.z + i.x) - i.z * i.x,
                     i.z * (i.x + i.y) - i.x * i.y};
  const Vec3<Real> m{X * i.x * M2.x, X * i.y * M2.y, X * i.z * M2.z};
  const Vec3<Real> u{(i.x * i.x + c.x) * X * M2.x, Real(2) * i.y * m.y,
                     (i.z * i.z + c.z) * X * M2.z};
  const Vec3<Real> w = scaled(c, m);

  const Real PX = P * X, QX = Q * X, yX = y * X, PQX = PX * QX;
  const auto shape = [&](const Vec3<Real>& a) {  // a_x C² + a_y C² D² + a_z D² in powers of S²
    return std::array<Real, 3>{a.x + a.y + a.z, -(QX * (a.x + a.y) + PX * (a.y + a.z)),
                               PQX * a.y};
  };
  const auto K1 = shape(m), K2 = shape(u), K3 = shape(w);
  const Real c1 = PX + QX + yX, c2 = PQX + yX * (PX + QX), c3 = PQX * yX;

  std::array<Real, angle_order> d, squares;
  Real D(0);
#pragma GCC unroll 16
  for (std::size_t n = 0; n < angle_order; ++n) {
    const auto number = [](std::size_t k) { return Real(static_cast<double>(k)); };
    Real e(0);
    if (n < 3) e = K3[n];
    if (n >= 1) e = e + (c1 * number(2 * n + 1) + K2[0]) * d[n - 1];
    if (n >= 2) e = e + (K2[1] - c2 * number(2 * n - 1)) * d[n - 2];
    if (n >= 3) e = e + (c3 * number(2 * n - 3) + K2[2]) * d[n - 3];
    if (n >= 2) {
      Real square(0);
      for (std::size_t a = 0; a <= n - 2; ++a) square = square + d[a] * d[n - 2 - a];
      squares[n - 2] = square;
    }
    for (std::size_t j = 0; j < 3; ++j)
      if (n >= 2 + j) e = e + K1[j] * squares[n - 2 - j];
    d[n] = e * Real(1.0 / static_cast<double>(2 * n + 3));
    D = D + d[n];
  }

  const Real C2 = Real(1) - QX, D2 = Real(1) - PX;
  const Quaternion<Real> r{denominator * E, S * (L.x * C2 + g.x * SE) * (i.x + D),
                           S * (L.y * C2 * D2 + g.y * SE) * (i.y + D),
                           S * (L.z * D2 + g.z * SE) * (i.z + D)};
  return r;
}

}  // namespace polhode
