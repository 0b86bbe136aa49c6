// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>
#include <optional>

#include "forces/laws/pair_value.hpp"
#include "polhode/model/short_range.hpp"

namespace polhode {

/// The Buckingham potential u = A exp(−B r) − c6/r⁶ [buckingham1938]. The potential has a maximum
/// at a short distance, the inner limit. Below the inner limit, the potential falls to −∞. Sites
/// closer than the inner limit would collapse onto each other. Below the inner limit, u and s are
/// NaN, so that the run stops.
template <class T = double>
struct Buckingham {
  T A = 0;             ///< [kJ/mol]
  T B = 0;             ///< [1/nm]
  T c6 = 0;            ///< [kJ/mol nm⁶]
  T inner_limit2 = 0;  ///< square of the inner limit [nm²]

  using Parameters = BuckinghamLaw;
  /// Mixes the parameters of two sites as GROMACS does, whatever the mixing rule: geometric means
  /// of A and C, arithmetic mean of 1/B.
  template <class Mean>
  static std::optional<Parameters> mixed(const Parameters& x, const Parameters& y, const Mean&) {
    return Parameters{std::sqrt(x.A * y.A), 2 / (1 / x.B + 1 / y.B), std::sqrt(x.C * y.C)};
  }
  static Buckingham of(double, double, const BuckinghamLaw& law) {
    const double r = inner_limit(law);
    return {static_cast<T>(law.A), static_cast<T>(law.B), static_cast<T>(law.C),
            static_cast<T>(r * r)};
  }
  Buckingham scaled_by(double s) const {
    return {A, B / s, c6 * std::pow(s, 6), inner_limit2 * s * s};
  }
  Buckingham<float> rounded() const {
    return {static_cast<float>(A), static_cast<float>(B), static_cast<float>(c6),
            static_cast<float>(inner_limit2)};
  }

  /// The distance at which u has its maximum [nm], or 0 if C is 0. This distance is the smaller
  /// solution of (B r)⁷ exp(−B r) = 6 C B⁶/A, found by bisection.
  static double inner_limit(const BuckinghamLaw& law) {
    const double target = 6 * law.C * std::pow(law.B, 6) / law.A;
    double low = 0, high = 7;  // bounds of B r; the left side of the equation rises up to B r = 7
    while (high - low > 1e-14 * high && high > 1e-300) {
      const double x = (low + high) / 2;
      (std::pow(x, 7) * std::exp(-x) < target ? low : high) = x;
    }
    return law.C == 0 ? 0 : high / law.B;
  }

  template <class Real>
  PairValue<Real> operator()(const InversePowers<Real>& inverse_r, Real r2) const {
    using C = Constant<Real>;
    const Real one_over_r = inverse_r.first(), inverse_r2 = inverse_r.second();
    const Real repulsion = C(A) * exp(C(-B) * (r2 * one_over_r));
    const Real attraction = C(c6) * (inverse_r2 * inverse_r2 * inverse_r2);
    const auto inside = r2 < Real(C(inner_limit2));
    const Real nothing(constant<Real>(std::numeric_limits<double>::quiet_NaN()));
    return {select(inside, nothing, repulsion - attraction),
            select(inside, nothing,
                   C(B) * repulsion * one_over_r - constant<Real>(6) * attraction * inverse_r2)};
  }

  /// The integral ∫ u r² dr from a to infinity [kJ/mol nm³].
  double integral_beyond(double a) const {
    const double x = B * a;
    return A * std::exp(-x) * (x * x + 2 * x + 2) / (B * B * B) - c6 / (3 * a * a * a);
  }
};

}  // namespace polhode
