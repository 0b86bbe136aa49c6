// SPDX-License-Identifier: MIT
// The split of 1/r into two parts, 1/r = u(r) + smooth(r). The short-range part u is summed over
// pairs, and the smooth part over wave vectors. The smooth part is the potential of a unit charge
// that is spread over a density. transform(k) is the Fourier transform of this density, with value
// 1 at k = 0.
#pragma once

#include <array>
#include <cmath>
#include <utility>

#include "forces/laws/smooth_polynomial.hpp"
#include "polhode/base/units.hpp"

namespace polhode {

/// A Fourier transform and its slope.
struct TransformValue {
  double value;  ///< value, which is 1 at k = 0
  double slope;  ///< slope k d/dk of the transform
};

/// Split of 1/r with a density C (1 − r²/a²)^m, which is zero beyond a. The smooth part is the
/// Taylor polynomial of 1/r in y = 1 − r²/a² up to y^(m+1) [skeel2002; hardy2009]. The short-range
/// part u(r) is also zero beyond a. u and its first m + 1 derivatives are continuous at r = a, so
/// the sum over pairs needs no truncation.
class CompactSplit {
 public:
  static constexpr int max_exponent =
      static_cast<int>(SmoothPolynomial::max_degree) - 1;  ///< the largest exponent m

  /// @param cutoff    cutoff a [nm]
  /// @param exponent  exponent m, from 0 to `max_exponent`
  CompactSplit(double cutoff, int exponent)
      : polynomial_(cutoff, inverse_distance_terms(exponent + 1)) {}

  double cutoff() const { return polynomial_.cutoff(); }
  const SmoothPolynomial& polynomial() const { return polynomial_; }
  RadialValue smooth(double r) const { return polynomial_.smooth(r); }
  RadialValue pair(double r) const { return polynomial_.pair(r); }
  double smooth_at_zero() const { return polynomial_.smooth_at_zero(); }

  /// The Fourier transform of the density: (2n+1)!! j_n(x)/xⁿ with n = m + 1, x = k a, and the
  /// spherical Bessel function j_n. The derivative of this transform is −(2n+1)!! j_(n+1)(x)/xⁿ.
  TransformValue transform(double k) const {
    const double x = k * cutoff();
    const auto [now, next] = reduced_bessel(degree(), x);
    return {now, -x * x / (2 * degree() + 3) * next};
  }
  /// The integral ∫ u dV over all space [nm²].
  double integral() const { return 2 * units::pi * cutoff() * cutoff() / (2 * degree() + 3); }

 private:
  int degree() const { return static_cast<int>(polynomial_.degree()); }

  // Computes (2n+1)!! j_n(x)/xⁿ for the degrees n and n + 1, by the power series if this loses no
  // digits, and otherwise by upward recurrence in n.
  static std::array<double, 2> reduced_bessel(int n, double x) {
    if (x < n + 1) return {bessel_series(n, x), bessel_series(n + 1, x)};
    const double inverse = 1 / (x * x);
    double now = std::sin(x) / x, next = 3 * (now - std::cos(x)) * inverse;
    for (int k = 1; k <= n; ++k)
      now = std::exchange(next, (2 * k + 3) * (2 * k + 1) * (next - now) * inverse);
    return {now, next};
  }
  static double bessel_series(int n, double x) {
    double term = 1, sum = 1;
    for (int k = 1; std::abs(term) > 1e-17 * std::abs(sum); ++k)
      sum += term *= -x * x / (2.0 * k * (2 * n + 2 * k + 1));
    return sum;
  }

  SmoothPolynomial polynomial_;
};

}  // namespace polhode
