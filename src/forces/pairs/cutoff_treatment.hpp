// SPDX-License-Identifier: MIT
// The cutoff treatment: how the interactions of two molecules are truncated.
#pragma once

#include "forces/laws/laws.hpp"
#include "polhode/base/always_inline.hpp"

namespace polhode {

/// The cutoff treatment of the pairs in a pair loop. `none` and `smooth_untruncated` are for
/// molecules known to lie inside the switching distance, where no interaction is truncated. With
/// `smooth` (PME, damped shifted force), a polynomial is subtracted from 1/r, so the Coulomb energy
/// already vanishes at the cutoff. The short-range potential is switched for each pair of sites.
enum class CutoffTreatment {
  none,
  molecule_switch,
  site_switch,
  site_shift,
  smooth_untruncated,
  smooth
};

constexpr bool switches_sites(CutoffTreatment treatment) {
  return treatment == CutoffTreatment::site_switch || treatment == CutoffTreatment::smooth;
}
constexpr bool is_smooth(CutoffTreatment treatment) {
  return treatment == CutoffTreatment::smooth || treatment == CutoffTreatment::smooth_untruncated;
}
/// Whether the truncation changes a potential at every distance, so that no pair is inside the
/// switching distance.
constexpr bool changes_all_distances(CutoffTreatment treatment) {
  return treatment == CutoffTreatment::site_shift;
}
/// The cutoff treatment of pairs inside the switching distance: the same potentials without
/// truncation.
constexpr CutoffTreatment without_truncation(CutoffTreatment treatment) {
  return is_smooth(treatment) ? CutoffTreatment::smooth_untruncated : CutoffTreatment::none;
}
constexpr bool vanishes_at_cutoff(Electrostatics electrostatics) {
  return electrostatics == Electrostatics::pme ||
         electrostatics == Electrostatics::damped_shifted_force;
}
constexpr CutoffTreatment cutoff_treatment(const ForceSettings& settings) {
  return vanishes_at_cutoff(settings.electrostatics)          ? CutoffTreatment::smooth
         : settings.truncation == Truncation::molecule_switch ? CutoffTreatment::molecule_switch
         : settings.truncation == Truncation::site_switch     ? CutoffTreatment::site_switch
                                                              : CutoffTreatment::site_shift;
}

/// Potentials between two sites at a given distance, truncated for each pair of sites.
template <CutoffTreatment treatment, class Real, class T>
class SiteTruncation {
 public:
  POLHODE_INLINE SiteTruncation(const PairLaws<T>& laws, const InversePowers<Real>& inverse_r,
                                const Real& r2)
      : laws_(laws), inverse_r_(inverse_r), r2_(r2) {
    if constexpr (switches_sites(treatment)) switch_ = laws.switching(r2 * inverse_r.first());
  }

  /// Evaluates u and −u'/r of a potential.
  template <class Law>
  POLHODE_INLINE PairValue<Real> operator()(const Law& law) const {
    const PairValue<Real> at_r = with_derivative(law(inverse_r_, r2_), r2_);
    if constexpr (switches_sites(treatment))
      return with_derivative(switched(at_r), r2_);
    else if constexpr (treatment == CutoffTreatment::site_shift)
      return with_derivative(shifted(at_r, law), r2_);
    else
      return at_r;
  }

 private:
  // Multiplies u and s = −u'/r by the switch w: the products are w u and w s − w' u/r.
  POLHODE_INLINE PairValue<Real> switched(const PairValue<Real>& at_r) const {
    return {switch_.w * at_r.u, switch_.w * at_r.s - switch_.slope * inverse_r_.first() * at_r.u};
  }
  // The shifted potential: u(r) − u(r_c) − (r − r_c) u'(r_c) for r < r_c, and zero beyond
  // [toxvaerd2011].
  template <class Law>
  POLHODE_INLINE PairValue<Real> shifted(const PairValue<Real>& at_r, const Law& law) const {
    using C = Constant<Real>;
    const C rc(laws_.cutoff), rc2(laws_.cutoff * laws_.cutoff);
    const PairValue<C> at_cutoff = law(InversePowers<C>(rc2), rc2);
    const C f = at_cutoff.s * rc;  // force −u'(r_c) at the cutoff
    const Real one_over_r = inverse_r_.first(), r = r2_ * one_over_r;
    const auto within = r < Real(rc);
    return {select(within, at_r.u - at_cutoff.u + (r - rc) * f, Real(0)),
            select(within, at_r.s - f * one_over_r, Real(0))};
  }

  const PairLaws<T>& laws_;
  const InversePowers<Real>& inverse_r_;
  const Real& r2_;
  typename Switch<T>::template Value<Real> switch_{};  // switch w(r) and its derivative w'(r)
};

}  // namespace polhode
