// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <optional>

#include "forces/laws/pair_value.hpp"
#include "polhode/model/short_range.hpp"

namespace polhode {

/// The Mie potential u = C ε ((σ/r)ⁿ − (σ/r)ᵐ) with C = n/(n − m) (n/m)^(m/(n − m)), so that the
/// well has the depth ε [mie1903]. Powers are computed as exp(n/2 ln(σ²/r²)). The relative error of
/// a power is |n ln(σ/r)| times the error of the logarithm. The relative error is small at
/// distances where the potential is strong.
template <class T = double>
struct Mie {
  T strength = 0;  ///< strength C ε [kJ/mol]
  T sigma2 = 0;    ///< σ² [nm²]
  T n = 12, m = 6;

  using Parameters = MieLaw;
  /// Mixes the exponents of two sites by the mean that the mixing rule uses for σ.
  template <class Mean>
  static std::optional<Parameters> mixed(const Parameters& x, const Parameters& y,
                                         const Mean& mean) {
    return Parameters{mean(x.n, y.n), mean(x.m, y.m)};
  }
  static Mie of(double sigma, double epsilon, const MieLaw& law) {
    const double n = law.n, m = law.m;
    const double factor = n / (n - m) * std::pow(n / m, m / (n - m));
    return {static_cast<T>(factor * epsilon), static_cast<T>(sigma * sigma), static_cast<T>(n),
            static_cast<T>(m)};
  }
  Mie scaled_by(double s) const { return {strength, sigma2 * (s * s), n, m}; }
  Mie<float> rounded() const {
    return {static_cast<float>(strength), static_cast<float>(sigma2), static_cast<float>(n),
            static_cast<float>(m)};
  }

  template <class Real>
  PairValue<Real> operator()(const InversePowers<Real>& inverse_r, Real) const {
    using C = Constant<Real>;
    const Real inverse_r2 = inverse_r.second();
    const Real logarithm = log(C(sigma2) * inverse_r2);  // 2 ln(σ/r)
    const Real repulsion = C(strength) * exp(constant<Real>(n / 2) * logarithm);
    const Real attraction = C(strength) * exp(constant<Real>(m / 2) * logarithm);
    return {repulsion - attraction, (C(n) * repulsion - C(m) * attraction) * inverse_r2};
  }

  /// The integral ∫ u r² dr from a to infinity [kJ/mol nm³]; m is above 3.
  double integral_beyond(double a) const {
    const double q = std::sqrt(sigma2) / a, a3 = a * a * a;
    return strength * a3 * (std::pow(q, n) / (n - 3) - std::pow(q, m) / (m - 3));
  }
};

}  // namespace polhode
