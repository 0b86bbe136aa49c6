// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <optional>

#include "forces/laws/pair_value.hpp"
#include "polhode/model/short_range.hpp"

namespace polhode {

/// The Lennard-Jones potential u = c12/r¹² − c6/r⁶, with c12 = 4 ε σ¹² and c6 = 4 ε σ⁶.
template <class T = double>
struct LennardJones {
  T c6 = 0;   ///< [kJ/mol nm⁶]
  T c12 = 0;  ///< [kJ/mol nm¹²]

  using Parameters = LennardJonesLaw;
  /// Mixes all parameters of two sites except σ and ε. The Lennard-Jones potential has no such
  /// parameters.
  template <class Mean>
  static std::optional<Parameters> mixed(const Parameters& x, const Parameters&, const Mean&) {
    return x;
  }
  static LennardJones of(double sigma, double epsilon, const LennardJonesLaw& = {}) {
    const double s2 = sigma * sigma, s6 = s2 * s2 * s2;
    return {static_cast<T>(4 * epsilon * s6), static_cast<T>(4 * epsilon * s6 * s6)};
  }
  LennardJones scaled_by(double s) const {
    const double s6 = std::pow(s, 6);
    return {c6 * s6, c12 * s6 * s6};
  }
  LennardJones<float> rounded() const { return {static_cast<float>(c6), static_cast<float>(c12)}; }

  template <class Real>
  PairValue<Real> operator()(const InversePowers<Real>& inverse_r, Real) const {
    using C = Constant<Real>;
    const Real inverse_r2 = inverse_r.second();
    const Real x = inverse_r2 * inverse_r2 * inverse_r2;
    const Real repulsion = C(c12) * x;
    return {(repulsion - C(c6)) * x,
            (constant<Real>(12) * repulsion - constant<Real>(6) * C(c6)) * (x * inverse_r2)};
  }

  /// The integral ∫ u r² dr from a to infinity [kJ/mol nm³].
  double integral_beyond(double a) const {
    return c12 / (9 * std::pow(a, 9)) - c6 / (3 * std::pow(a, 3));
  }
};

}  // namespace polhode
