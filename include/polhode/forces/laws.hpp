// SPDX-License-Identifier: MIT
// The pair laws, each written once for every Real: numbers, packs, dual numbers. A law is a
// function of the distance r of two sites and returns u and s = −u'(r)/r, so that the force of the
// first on the second is s (r₂ − r₁).
#pragma once

#include <array>

#include "polhode/base/real.hpp"
#include "polhode/forces/settings.hpp"

namespace polhode {

template <class Real>
struct PairValue {
  Real u;  ///< energy [kJ/mol]
  Real s;  ///< −u'/r [kJ/mol/nm²]
};

/// u = c12/r¹² − c6/r⁶, with c12 = 4 ε σ¹² and c6 = 4 ε σ⁶.
struct LennardJones {
  double c6 = 0;   ///< [kJ/mol nm⁶]
  double c12 = 0;  ///< [kJ/mol nm¹²]

  static LennardJones of(double sigma, double epsilon) {
    const double s2 = sigma * sigma, s6 = s2 * s2 * s2;
    return {4 * epsilon * s6, 4 * epsilon * s6 * s6};
  }

  template <class Real>
  PairValue<Real> operator()(Real inverse_r2) const {
    const Real inverse_r6 = inverse_r2 * inverse_r2 * inverse_r2;
    const Real attraction = Real(c6) * inverse_r6;
    const Real repulsion = Real(c12) * inverse_r6 * inverse_r6;
    return {repulsion - attraction, (Real(12.0) * repulsion - Real(6.0) * attraction) * inverse_r2};
  }
};

/// Coulomb's law with a reaction field of a dielectric continuum beyond the cutoff:
/// u = K q₁ q₂ (1/r + k r² − c) with k = (ε − 1)/((2 ε + 1) r_c³) and c = 1/r_c + k r_c².
/// With k = c = 0 it is Coulomb's law. The strength K q₁ q₂ multiplies outside.
struct ReactionField {
  double k = 0;  ///< [1/nm³]
  double c = 0;  ///< [1/nm]

  /// @param dielectric  relative permittivity beyond the cutoff; may be infinite
  static ReactionField of(double dielectric, double cutoff) {
    const double ratio = dielectric > 1e15 ? 0.5 : (dielectric - 1) / (2 * dielectric + 1);
    const double k = ratio / (cutoff * cutoff * cutoff);
    return {k, 1 / cutoff + k * cutoff * cutoff};
  }

  template <class Real>
  PairValue<Real> operator()(Real inverse_r, Real r2) const {
    return {inverse_r + Real(k) * r2 - Real(c), inverse_r * inverse_r * inverse_r - Real(2 * k)};
  }
};

/// The smooth step w: 1 up to `from`, 0 from `to` on; between them, with x = (r − from)/(to −
/// from), the polynomial of lowest degree whose first `smoothness` derivatives vanish at both ends.
class Switch {
 public:
  template <class Real>
  struct Value {
    Real w;      ///< 1 to 0
    Real slope;  ///< w'(r) [1/nm]
  };

  Switch(double from, double to, int smoothness)
      : from_(from), inverse_width_(1 / (to - from)), a_(coefficients(smoothness)) {}

  template <class Real>
  Value<Real> operator()(Real r) const {
    Real x = (r - Real(from_)) * Real(inverse_width_);
    x = select(x < Real(0.0), Real(0.0), x);
    x = select(x > Real(1.0), Real(1.0), x);
    Real w(a_[7]), slope(7 * a_[7]);
    for (int n = 6; n >= 1; --n) {
      w = w * x + Real(a_[static_cast<unsigned>(n)]);
      slope = slope * x + Real(n * a_[static_cast<unsigned>(n)]);
    }
    return {w * x + Real(1.0), slope * Real(inverse_width_)};
  }

 private:
  using Coefficients = std::array<double, 8>;  // of 1, x, ..., x⁷: integers, so w(1) = 0 exactly

  static constexpr Coefficients coefficients(int smoothness) {
    switch (smoothness) {
      case 1:
        return {1, 0, -3, 2};
      case 2:
        return {1, 0, 0, -10, 15, -6};
      default:
        return {1, 0, 0, 0, -35, 84, -70, 20};
    }
  }

  double from_, inverse_width_;
  Coefficients a_;
};

/// All that two sites need to know of the force field beside their own parameters.
struct PairLaws {
  Truncation truncation;
  ReactionField reaction_field;
  Switch switching;
  double from2, cutoff2;  ///< squares of where the switch begins and ends [nm²]

  explicit PairLaws(const ForceSettings& settings)
      : truncation(settings.truncation),
        reaction_field(settings.truncation == Truncation::reaction_field
                           ? ReactionField::of(settings.dielectric, settings.cutoff)
                           : ReactionField{}),
        switching(settings.switch_from, settings.cutoff, settings.smoothness),
        from2(settings.switch_from * settings.switch_from),
        cutoff2(settings.cutoff * settings.cutoff) {}
};

}  // namespace polhode
