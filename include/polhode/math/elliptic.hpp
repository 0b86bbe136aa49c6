// SPDX-License-Identifier: MIT
// Jacobi's elliptic functions and integrals of the first and third kind. The caller gives both the
// modulus k and its complement k'. Near k = 1, k' cannot be computed accurately from k. Near k' =
// 1, k cannot be computed accurately from k'.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace polhode {

/// Jacobi's elliptic functions sn, cn and dn of one argument.
struct JacobiFunctions {
  double sn, cn, dn;
};

/// The modulus k and its complement k' = √(1 − k²), each to full relative accuracy.
struct Modulus {
  double k, complement;
};

/// The quarter period K(k) = π/(2 agm(1, k')); infinite for k' = 0.
inline double quarter_period(const Modulus& modulus) {
  if (modulus.complement == 0) return std::numeric_limits<double>::infinity();
  double a = 1, b = modulus.complement;
  // The arithmetic and geometric means converge quadratically: once they differ by less than √ε,
  // the next mean is exact.
  while (std::abs(a - b) > 1e-8 * a) {
    const double mean = 0.5 * (a + b);
    b = std::sqrt(a) * std::sqrt(b);
    a = mean;
  }
  return 3.14159265358979323846 / (a + b);
}

namespace elliptic {

/// The functions sn, cn and dn for |u| ≤ K/2 by descending Landen transformations (k → 0, DLMF
/// 22.7.2 to 22.7.4). No terms cancel, so each function keeps its relative accuracy.
inline JacobiFunctions descending(double u, const Modulus& modulus) {
  if (!(modulus.k >= 1e-9)) return {std::sin(u), std::cos(u), 1.0};  // the error is k² u/4 < ε
  const double half = modulus.k / (1 + modulus.complement);
  const double k1 = half * half;  // (1 − k')/(1 + k')
  const Modulus smaller{k1, std::sqrt((1 - k1) * (1 + k1))};
  const auto [s, c, d] = descending(u / (1 + k1), smaller);
  const double denominator = 1 + k1 * s * s;
  return {(1 + k1) * s / denominator, c * d / denominator, (1 - k1 * s * s) / denominator};
}

/// The functions sn, cn and dn by ascending Landen transformations (k → 1, DLMF 22.7.6 to 22.7.8),
/// for k > k'.
inline JacobiFunctions ascending(double u, const Modulus& modulus) {
  // For |u| ≤ K/2, the error of the limits tanh and sech is below k'² cosh²u ≈ 4 k', so they are
  // used for k' < 1e-17.
  if (!(modulus.complement >= 1e-17)) {
    const double e = std::exp(-std::abs(u)),
                 sech = 2 * e / (1 + e * e);  // avoids cosh, which would overflow
    return {std::tanh(u), sech, sech};
  }
  const double half = modulus.complement / (1 + modulus.k);
  const double c2 = half * half;  // the complement of the next modulus, (1 − k)/(1 + k)
  const double k2_squared = (1 - c2) * (1 + c2);
  const auto [s, c, d] = ascending(u / (1 + c2), {std::sqrt(k2_squared), c2});
  return {(1 + c2) * s * c / d, (1 + c2) * (d * d - c2) / (k2_squared * d),
          (1 - c2) * (d * d + c2) / (k2_squared * d)};
}

}  // namespace elliptic

/// The functions sn(u), cn(u) and dn(u) for |u| ≤ K, where `K` is the quarter period. Relative
/// errors are a few ε. Beyond K/2 the functions are computed from K − |u|. Near their minima, cn
/// and dn are therefore as accurate as K − |u|.
inline JacobiFunctions jacobi_functions(double u, const Modulus& modulus, double K) {
  const auto near_zero =
      modulus.k > modulus.complement ? &elliptic::ascending : &elliptic::descending;
  const double distance = std::abs(u);
  if (distance <= 0.5 * K) return near_zero(u, modulus);
  const auto [s, c, d] = near_zero(K - distance, modulus);
  return {std::copysign(c / d, u), modulus.complement * (s / d), modulus.complement / d};
}

/// Carlson's R_F(x, y, z) = ½ ∫₀^∞ ds/√((s+x)(s+y)(s+z)), for arguments ≥ 0. At most one argument
/// is 0. The relative error is a few ε.
/// @source DLMF 19.36(i)
inline double first_kind_integral(double x, double y, double z) {
  for (;;) {
    const double mean = (x + y + z) / 3;
    const double dx = 1 - x / mean, dy = 1 - y / mean, dz = 1 - z / mean;
    // The error of the series truncated before sixth order is 0.26 · 0.0025⁶ < ε/2.
    if (!(std::max({std::abs(dx), std::abs(dy), std::abs(dz)}) >= 0.0025)) {
      const double e2 = dx * dy - dz * dz, e3 = dx * dy * dz;
      return (1 - e2 / 10 + e3 / 14 + e2 * e2 / 24 - 3 * e2 * e3 / 44) / std::sqrt(mean);
    }
    const double lambda =
        std::sqrt(x) * std::sqrt(y) + (std::sqrt(x) + std::sqrt(y)) * std::sqrt(z);
    x = 0.25 * (x + lambda);
    y = 0.25 * (y + lambda);
    z = 0.25 * (z + lambda);
  }
}

/// The integral ∫₀ᵘ sn²/(1 + n sn²) du = sn³/3 · R_J(cn², dn², 1, 1 + n sn²), from the values f of
/// sn, cn and dn at u. The formula is valid for n ≥ 0 and sn ≥ 0 in the first quarter period. This
/// integral equals Legendre's (F − Π)/n, but does not lose digits at small n.
/// @source DLMF 19.25.14 and 19.36(i): Carlson's duplication. Here δ = (p−x)(p−y)(p−z) is sn⁶ n
///   (1+n)(n+k²), which needs no subtraction.
inline double third_kind_integral(const JacobiFunctions& f, double n, double k) {
  const double s2 = f.sn * f.sn;
  // The first duplication uses the roots cn and dn directly, because cn² and dn² may underflow.
  double root_x = std::abs(f.cn), root_y = f.dn, root_z = 1;
  double x = root_x * root_x, y = root_y * root_y, z = 1, p = 1 + n * s2;
  double root_p = std::sqrt(p);
  double delta = s2 * s2 * s2 * n * (1 + n) * (n + k * k);
  double power = 1, sum = 0;
  for (;;) {
    const double lambda = root_x * root_y + root_x * root_z + root_y * root_z;
    const double d = (root_p + root_x) * (root_p + root_y) * (root_p + root_z);
    const double e = delta / (d * d);
    const double root_e = std::sqrt(e);
    // R_C(1, 1 + e) equals atan(√e)/√e. For e < 1e-6, the second-order series of this function is
    // exact to round-off.
    sum += power / d * (e < 1e-6 ? 1 - e * (1.0 / 3 - e * (1.0 / 5)) : std::atan(root_e) / root_e);
    power *= 0.25;
    delta *= 1.0 / 64;
    x = 0.25 * (x + lambda);
    y = 0.25 * (y + lambda);
    z = 0.25 * (z + lambda);
    p = 0.25 * (p + lambda);
    const double mean = (x + y + z + 2 * p) * 0.2;
    const double dx = 1 - x / mean, dy = 1 - y / mean, dz = 1 - z / mean;
    // The error of the series truncated before sixth order is 3/10 · 0.0025⁶ < ε/2.
    if (!(std::max({std::abs(dx), std::abs(dy), std::abs(dz)}) >= 0.0025)) {
      const double dp = -0.5 * (dx + dy + dz);
      const double e2 = dx * dy + dx * dz + dy * dz - 3 * dp * dp;
      const double e3 = dx * dy * dz + 2 * e2 * dp + 4 * dp * dp * dp;
      const double e4 = (2 * dx * dy * dz + e2 * dp + 3 * dp * dp * dp) * dp;
      const double e5 = dx * dy * dz * dp * dp;
      const double series = 1 - 3 * e2 / 14 + e3 / 6 + 9 * e2 * e2 / 88 - 3 * e4 / 22 -
                            9 * e2 * e3 / 52 + 3 * e5 / 26;
      const double rj = power * series / (mean * std::sqrt(mean)) + 6 * sum;
      return s2 * f.sn * rj / 3;
    }
    root_x = std::sqrt(x);
    root_y = std::sqrt(y);
    root_z = std::sqrt(z);
    root_p = std::sqrt(p);
  }
}

}  // namespace polhode
