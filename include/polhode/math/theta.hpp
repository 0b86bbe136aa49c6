// SPDX-License-Identifier: MIT
// Theta functions of complex argument, and the elliptic integral of the third kind, which these
// functions give for any argument.
#pragma once

#include <complex>
#include <numbers>

#include "polhode/math/elliptic.hpp"

namespace polhode {

/// A series that gives both of Jacobi's functions θ₄ and θ₂, with PM = q²:
///
///     S(P, M) = 1 + Σ_{n≥1} (−1)ⁿ q^{n²−n} (Pⁿ + Mⁿ),    D = (P ∂/∂P − M ∂/∂M) S,
///     θ₄(z) = S(q e^{−2iz}, q e^{2iz}),   θ₄'(z) = −2i D,
///     θ₂(z) = q^{1/4} e^{iz} S(−e^{−2iz}, −q² e^{2iz}).
///
/// The caller supplies P and M, because e^{2|Im z|} may overflow even where q e^{2|Im z|} ≤ 1.
struct ThetaSeries {
  std::complex<double> S, D;
};

/// @param P, M  at most 1 in absolute value
/// @param q     the nome, 0 to e^{−π}: the fifth terms, 5 q²⁰, are below 1e-26
/// @return      S and D, with absolute errors of a few ε
/// @source      DLMF 20.2.2, 20.2.4; tests/unit/theta_test.cpp
inline ThetaSeries theta_series(std::complex<double> P, std::complex<double> M, double q) {
  std::complex<double> power_P = 1, power_M = 1, S = 1, D = 0;
  double weight = 1, raise = 1;  // (−1)ⁿ q^{n²−n} and q^{2n−2}
  for (double n = 1; n <= 4; ++n) {
    power_P *= P;
    power_M *= M;
    weight *= -raise;
    raise *= q * q;
    S += weight * (power_P + power_M);
    D += n * weight * (power_P - power_M);
  }
  return {S, D};
}

/// The integral κ ∫₀ᵛ sn²/(1 + n sn²) du with κ² = n(1+n)(n+k²), κ > 0, computed as a term linear
/// in v minus the complex argument of a theta function [vanzon2007a, Sec. 3; jacobi1849]. With
/// sc(b, k') = √n/k and Jacobi's zeta function Z, the integral is
///
///     −i Z(ib, k) v − arg θ₄(π (v + ib)/2K),                         q = exp(−π K'/K),
///
/// or, by Jacobi's imaginary transformation, with sums of the complementary nome,
///
///     [√(n(1+n)/(n+k²)) − Z(b, k') − y/K] v − [arg θ₂(y − iπv/2K') − y v/K],
///
/// with y = π b/2K' and q = exp(−π K/K'). ThetaIntegral uses the form with the smaller nome. This
/// nome never exceeds e^{−π}, so four terms suffice for every k, including the separatrix (k = 1, q
/// = 0). The subtracted term has the period 2K and needs v only modulo 2K, but the linear term
/// needs the full v.
class ThetaIntegral {
 public:
  /// Whether the nome can be computed from k, which requires that k² does not underflow. For a top,
  /// k² underflows if two moments are equal, or if L is within about 1e-140 of the axis around
  /// which L circles.
  static bool applies(const Modulus& modulus) {
    return modulus.k * modulus.k >= std::numeric_limits<double>::min();
  }

  /// @param n  0 to 1
  /// @param K  quarter_period(modulus)
  ThetaIntegral(double n, const Modulus& modulus, double K)
      : K_(K),
        other_K_(quarter_period({modulus.complement, modulus.k})),
        complementary_(modulus.k > modulus.complement) {
    using std::numbers::pi;
    const double m = modulus.k * modulus.k;
    if (complementary_) {
      const double y =
          0.5 * pi * std::sqrt(n) * first_kind_integral(m, m * (1 + n), m + n) / other_K_;
      q_ = std::exp(-pi * K_ / other_K_);
      turn_ = std::polar(1.0, 2 * y);
      const ThetaSeries at_y = theta_series(q_ * std::conj(turn_), q_ * turn_, q_);
      const double zeta = pi / other_K_ * (at_y.D.imag() / at_y.S.real());
      rate_ = std::sqrt(n * (1 + n) / (n + m)) - zeta - y / K_;
      y_ = y;
    } else {
      const double rest = std::min(other_K_, first_kind_integral(n, n + m, n + 1));  // K' − b
      q_ = std::exp(-pi * other_K_ / K_);
      P_ = std::exp(-pi * rest / K_);
      M_ = q_ * std::exp(-pi * (other_K_ - rest) / K_);
      const ThetaSeries at_y = theta_series(P_, M_, q_);
      rate_ = -pi / K_ * (at_y.D.real() / at_y.S.real());
    }
  }

  /// The coefficient of v: the mean of the integrand over a period, times κ.
  double rate() const { return rate_; }

  /// The term that is subtracted from rate() v, between −π/2 and π/2.
  /// @param v  argument reduced modulo 2K to |v| ≤ K
  double argument(double v) const {
    using std::numbers::pi;
    if (complementary_) {
      const double x = std::abs(v) * (0.5 * pi / other_K_);
      const double near_K = std::exp(-pi * (K_ - std::abs(v)) / other_K_);
      const auto S = theta_series(-std::exp(-2 * x) * std::conj(turn_), -q_ * near_K * turn_, q_).S;
      return std::copysign(y_ * (1 - std::abs(v) / K_) + std::arg(S), v);
    }
    const std::complex<double> turn = std::polar(1.0, v * (pi / K_));
    return std::arg(theta_series(P_ * std::conj(turn), M_ * turn, q_).S);
  }

 private:
  double K_, other_K_;
  bool complementary_;
  double q_, rate_;
  double y_ = 0;                   // π b/2K' for the form with θ₂, and
  std::complex<double> turn_ = 1;  // e^{2iy}
  double P_ = 0, M_ = 0;           // q e^{±π b/K}
};

}  // namespace polhode
