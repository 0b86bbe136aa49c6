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
      : from_(from), inverse_width_(1 / (to - from)), n_(smoothness), inner_(inner(smoothness)) {}

  template <class Real>
  Value<Real> operator()(Real r) const {
    Real x = (r - Real(from_)) * Real(inverse_width_);
    x = select(x < Real(0.0), Real(0.0), x);
    x = select(x > Real(1.0), Real(1.0), x);
    Real p(inner_[3]), power = x;
    for (std::size_t k = 3; k-- > 0;) p = p * x + Real(inner_[k]);
    const Real bump = x * (Real(1.0) - x);
    Real slope = Real(slope_factor() * inverse_width_);
    for (int k = 0; k < n_; ++k) {
      power = power * x;
      slope = slope * bump;
    }
    return {Real(1.0) - power * p, slope};
  }

 private:
  // w = 1 − xⁿ⁺¹ p(x), with whole coefficients and p(1) = 1, so that w(1) = 0 exactly;
  // w' = −c xⁿ (1 − x)ⁿ.
  static constexpr std::array<double, 4> inner(int n) {
    switch (n) {
      case 1:
        return {3, -2};
      case 2:
        return {10, -15, 6};
      default:
        return {35, -84, 70, -20};
    }
  }
  double slope_factor() const { return n_ == 1 ? -6 : n_ == 2 ? -30 : -140; }

  double from_, inverse_width_;
  int n_;
  std::array<double, 4> inner_;
};

/// All that two sites need to know of the force field beside their own parameters.
struct PairLaws {
  Truncation truncation;
  ReactionField reaction_field;
  Switch switching;

  explicit PairLaws(const ForceSettings& settings)
      : truncation(settings.truncation),
        reaction_field(settings.truncation == Truncation::reaction_field
                           ? ReactionField::of(settings.dielectric, settings.cutoff)
                           : ReactionField{}),
        switching(settings.switch_from, settings.cutoff, settings.smoothness) {}
};

}  // namespace polhode
