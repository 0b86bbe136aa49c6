// SPDX-License-Identifier: MIT
// The potentials of charges, and code shared by all pair potentials, written once for every Real:
// numbers, packs, dual numbers. A law returns the potential u and s = −u'(r)/r as functions of the
// distance r between two sites. The force of the first site on the second is s (r₂ − r₁).
#pragma once

#include <array>
#include <optional>

#include "forces/laws/damped_shifted_force.hpp"
#include "forces/laws/ewald_split.hpp"
#include "forces/laws/gaussian_smooth_part.hpp"
#include "forces/laws/pair_value.hpp"
#include "polhode/base/always_inline.hpp"
#include "polhode/forces/laws/settings.hpp"

namespace polhode {

/// The Coulomb potential with the reaction field of a dielectric continuum beyond the cutoff: u = K
/// q₁ q₂ (1/r + k r² − c). The constants are k = (ε − 1)/((2 ε + 1) r_c³) and c = 1/r_c + k r_c²
/// [tironi1995]. The plain Coulomb potential has k = c = 0. The caller multiplies the result by the
/// factor K q₁ q₂.
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

/// The switching function w, which is 1 up to `from` and 0 beyond `to`. In between, w is a
/// polynomial in x = (r − from)/(to − from). This polynomial has the lowest degree for which the
/// first `smoothness` derivatives vanish at both ends. With y = x − ½ and b = ¼ − y² = x (1 − x), w
/// = ½ − y Σ B_k bᵏ for k from 0 to n, and dw/dx = −(2n + 1) B_n bⁿ. The coefficients B_k =
/// (2k)!/k!² are 1, 2, 6, 20. This form needs the same operations for all n and no branches. The
/// form is exact at both ends, where b = 0.
template <class T = double>
class Switch {
 public:
  template <class Real>
  struct Value {
    Real w;      ///< value, from 1 to 0
    Real slope;  ///< derivative w'(r) [1/nm]
  };

  /// @param smoothness  n, from 1 to 3
  Switch(double from, double to, int smoothness)
      : inverse_width_(static_cast<T>(1 / (to - from))), middle_(static_cast<T>((from + to) / 2)) {
    const auto n = static_cast<std::size_t>(smoothness);
    for (std::size_t k = 0; k <= n; ++k) p_[k] = static_cast<T>(B[k]);
    slope_[n] = static_cast<T>((2 * smoothness + 1) * B[n] / (from - to));
  }

  template <class Real>
  POLHODE_INLINE Value<Real> operator()(const Real& r) const {
    using C = Constant<Real>;
    const C half(T(0.5));
    const Real y = max(min((r - C(middle_)) * C(inverse_width_), half), -half);
    const Real b = C(T(0.25)) - y * y;
    const Real p = C(p_[0]) + b * (C(p_[1]) + b * (C(p_[2]) + b * C(p_[3])));
    const Real slope = b * (C(slope_[1]) + b * (C(slope_[2]) + b * C(slope_[3])));
    return {with_derivative(half - y * p, slope, r), slope};
  }

 private:
  static constexpr std::array<double, 4> B{1, 2, 6, 20};

  T inverse_width_, middle_;        // y = (r − middle) inverse_width
  std::array<T, 4> p_{}, slope_{};  // coefficients of the powers of b in w and w'
};

/// The polynomial subtracted from 1/r inside the cutoff a, as powers of y = 1 − r²/a², which is the
/// form that the kernels use. The difference u of 1/r and the polynomial goes smoothly to zero at
/// a. The caller multiplies the result by the factor K q₁ q₂.
template <class T = double>
struct SmoothPart {
  std::size_t degree = 0;  ///< degree of −u'/r; the degree of u is larger by one
  T inverse_a2 = 0;        ///< 1/a² [1/nm²]
  std::array<T, SmoothPolynomial::max_degree + 1> u{}, s{};  ///< coefficients of u [1/nm] and of
                                                             ///< −u'/r [1/nm³]

  explicit SmoothPart(const std::optional<SmoothPolynomial>& polynomial) {
    if (!polynomial) return;
    const double a = polynomial->cutoff();
    degree = polynomial->degree() - 1;
    inverse_a2 = static_cast<T>(1 / (a * a));
    for (std::size_t k = 0; k <= degree + 1; ++k)
      u[k] = static_cast<T>(polynomial->coefficient(k) / a);
    for (std::size_t k = 0; k <= degree; ++k)
      s[k] = static_cast<T>(polynomial->slope_coefficient(k) / (a * a * a));
  }
};

/// The polynomial that the force field subtracts from 1/r, if any: the smooth part of the PME split
/// or of Ewald's split, or the polynomial of the damped shifted force.
inline std::optional<SmoothPolynomial> smooth_polynomial(const ForceSettings& settings) {
  if (settings.electrostatics == Electrostatics::damped_shifted_force)
    return damped_shifted_force(settings.cutoff, settings.damping, settings.smoothness);
  if (settings.ewald_alpha) return gaussian_smooth_part(settings.cutoff, *settings.ewald_alpha);
  if (settings.mesh)
    return CompactSplit(settings.mesh->cutoff, settings.mesh->exponent).polynomial();
  return std::nullopt;
}

/// The settings that determine the interaction of two sites, besides the parameters of the sites.
template <class T = double>
struct PairLaws {
  ReactionField<T> reaction_field;
  SmoothPart<T> smooth;
  Switch<T> switching;
  T cutoff;             ///< cutoff of the short-range potentials [nm]
  T cutoff_of_charges;  ///< cutoff between charges [nm]

  explicit PairLaws(const ForceSettings& settings)
      : reaction_field(settings.electrostatics == Electrostatics::reaction_field
                           ? ReactionField<T>::of(settings.dielectric, settings.cutoff)
                           : ReactionField<T>{}),
        smooth(smooth_polynomial(settings)),
        switching(settings.switch_from, settings.cutoff, settings.smoothness),
        cutoff(static_cast<T>(settings.cutoff)),
        cutoff_of_charges(static_cast<T>(polhode::cutoff_of_charges(settings))) {}
};

}  // namespace polhode
