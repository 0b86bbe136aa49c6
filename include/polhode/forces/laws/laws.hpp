// SPDX-License-Identifier: MIT
// The laws of charges, and what all pair laws have in common, each written once for every Real:
// numbers, packs, dual numbers. A law is a function of the distance r between two sites and returns
// u and s = −u'(r)/r; the force of the first site on the second is s (r₂ − r₁).
#pragma once

#include <array>
#include <optional>

#include "polhode/forces/laws/damped_shifted_force.hpp"
#include "polhode/forces/laws/ewald_split.hpp"
#include "polhode/forces/laws/pair_value.hpp"
#include "polhode/forces/laws/settings.hpp"

namespace polhode {

/// Coulomb's law with the reaction field of a dielectric continuum beyond the cutoff: u = K q₁ q₂
/// (1/r + k r² − c) with k = (ε − 1)/((2 ε + 1) r_c³) and c = 1/r_c + k r_c² [tironi1995].
/// k = c = 0 gives the plain Coulomb law. The factor K q₁ q₂ is applied by the caller.
template <class T = double>
struct ReactionField {
  T k = 0;  ///< [1/nm³]
  T c = 0;  ///< [1/nm]

  /// @param dielectric  relative permittivity beyond the cutoff; may be infinite
  static ReactionField of(double dielectric, double cutoff) {
    const double ratio = dielectric > 1e15 ? 0.5 : (dielectric - 1) / (2 * dielectric + 1);
    const double k = ratio / (cutoff * cutoff * cutoff);
    return {static_cast<T>(k), static_cast<T>(1 / cutoff + k * cutoff * cutoff)};
  }

  template <class Real>
  PairValue<Real> operator()(const InversePowers<Real>& inverse_r, Real r2) const {
    return {inverse_r.first() + (constant<Real>(k) * r2 - constant<Real>(c)),
            inverse_r.third() - constant<Real>(2 * k)};
  }
};

/// The smooth step w: 1 up to `from`, 0 beyond `to`; in between, with x = (r − from)/(to − from),
/// the polynomial of lowest degree whose first `smoothness` derivatives vanish at both ends.
template <class T = double>
class Switch {
 public:
  template <class Real>
  struct Value {
    Real w;      ///< from 1 to 0
    Real slope;  ///< w'(r) [1/nm]
  };

  Switch(double from, double to, int smoothness)
      : from_(static_cast<T>(from)),
        inverse_width_(static_cast<T>(1 / (to - from))),
        smoothness_(smoothness) {}

  template <class Real>
  Value<Real> operator()(Real r) const {
    Real x = (r - constant<Real>(from_)) * constant<Real>(inverse_width_);
    x = select(x < Real(0), Real(0), x);
    x = select(x > Real(1), Real(1), x);
    const Value<Real> step = smoothness_ == 1 ? C1(x) : smoothness_ == 2 ? C2(x) : C3(x);
    return {with_derivative(step.w, step.slope, x), step.slope * constant<Real>(inverse_width_)};
  }

 private:
  // w = 1 − xⁿ⁺¹ p(x), with integer coefficients and p(1) = 1, so that w(1) = 0 exactly; dw/dx = −c
  // xⁿ (1 − x)ⁿ.
  template <class Real>
  static Value<Real> C1(Real x) {
    using C = Constant<Real>;
    const Real p = C(3) - C(2) * x;
    return {C(1) - x * x * p, C(-6) * (x * (C(1) - x))};
  }
  template <class Real>
  static Value<Real> C2(Real x) {
    using C = Constant<Real>;
    const Real p = C(10) + x * (C(-15) + x * C(6)), bump = x * (C(1) - x);
    return {C(1) - x * x * x * p, C(-30) * (bump * bump)};
  }
  template <class Real>
  static Value<Real> C3(Real x) {
    using C = Constant<Real>;
    const Real p = C(35) + x * (C(-84) + x * (C(70) + x * C(-20)));
    const Real x2 = x * x, bump = x * (C(1) - x);
    return {C(1) - x2 * x2 * p, C(-140) * (bump * bump * bump)};
  }

  T from_, inverse_width_;
  int smoothness_;
};

/// The polynomial subtracted from 1/r inside the cutoff a, in the form the kernels use: powers of
/// y = 1 − r²/a². u = 1/r minus the polynomial goes smoothly to zero at a. The factor K q₁ q₂ is
/// applied by the caller.
template <class T = double>
struct SmoothPart {
  std::size_t degree = 0;  ///< of −u'/r; that of u is one higher
  T inverse_a2 = 0;        ///< 1/a² [1/nm²]
  std::array<T, SmoothPolynomial::max_degree + 1> u{}, s{};  ///< coefficients [1/nm], [1/nm³]

  SmoothPart() = default;
  explicit SmoothPart(const SmoothPolynomial& polynomial)
      : degree(polynomial.degree() - 1),
        inverse_a2(static_cast<T>(1 / (polynomial.cutoff() * polynomial.cutoff()))) {
    const double a = polynomial.cutoff();
    for (std::size_t k = 0; k <= degree + 1; ++k)
      u[k] = static_cast<T>(polynomial.coefficient(k) / a);
    for (std::size_t k = 0; k <= degree; ++k)
      s[k] = static_cast<T>(polynomial.slope_coefficient(k) / (a * a * a));
  }
};

/// The polynomial that the force field subtracts from 1/r, if any: the smooth part of the PME
/// split, or that of the damped shifted force.
inline std::optional<SmoothPolynomial> smooth_polynomial(const ForceSettings& settings) {
  if (settings.electrostatics == Electrostatics::damped_shifted_force)
    return damped_shifted_force(settings.cutoff, settings.damping, settings.smoothness);
  if (settings.mesh) return CompactSplit(settings.cutoff, settings.mesh->exponent).polynomial();
  return std::nullopt;
}

/// What the interaction of two sites depends on besides their own parameters.
template <class T = double>
struct PairLaws {
  ReactionField<T> reaction_field;
  SmoothPart<T> smooth;
  Switch<T> switching;
  T cutoff;  ///< [nm]

  explicit PairLaws(const ForceSettings& settings)
      : reaction_field(settings.electrostatics == Electrostatics::reaction_field
                           ? ReactionField<T>::of(settings.dielectric, settings.cutoff)
                           : ReactionField<T>{}),
        smooth(smooth_part(settings)),
        switching(settings.switch_from, settings.cutoff, settings.smoothness),
        cutoff(static_cast<T>(settings.cutoff)) {}

 private:
  static SmoothPart<T> smooth_part(const ForceSettings& settings) {
    const auto polynomial = smooth_polynomial(settings);
    return polynomial ? SmoothPart<T>(*polynomial) : SmoothPart<T>();
  }
};

}  // namespace polhode
