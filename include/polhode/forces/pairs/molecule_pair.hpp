// SPDX-License-Identifier: MIT
// The interaction of two rigid molecules: the sum over all pairs of their sites, truncated smoothly
// at the cutoff. Written once as a template over the number type: plain numbers, packs (one
// molecule with several partners at once, one in each lane) and dual numbers of either, which also
// give the derivative of forces and torques along a displacement of the molecules.
//
// A function that is called once for each pair of molecules is inlined into the loop over them:
// what the compiler knows there, such as the number of sites, it then knows here.
#pragma once

#include <array>

#include "polhode/forces/pairs/cutoff_treatment.hpp"
#include "polhode/forces/pairs/site_counts.hpp"
#include "polhode/math/polynomial.hpp"

namespace polhode {

/// Force and torque that molecule a exerts on molecule b; the force on a is −f.
template <class Real>
struct PairLoad {
  Vec3<Real> f{};                   ///< force on b [kJ/mol/nm]
  Vec3<Real> tau_b{};               ///< torque on b about its centre [kJ/mol]
  Real van_der_waals{}, coulomb{};  ///< [kJ/mol]; only if requested

  /// Torque on a about its centre [kJ/mol]. Every force acts along the line between two sites or
  /// between the centres, so the torques about any common point cancel: tau_a + tau_b + R × f = 0.
  /// If all sites are at the centre, the result is 0 only to rounding.
  Vec3<Real> tau_a(const Vec3<Real>& R) const { return -(tau_b + cross(R, f)); }
};

/// The switch between centres of mass: U = w(R) u has the forces w s between sites, and −w'(R) u
/// between the centres.
template <class Real, class T>
class MoleculeSwitch {
 public:
  [[gnu::always_inline]] MoleculeSwitch(const Switch<T>& switching, const Vec3<Real>& R) : R_(R) {
    const Real R2 = norm2(R);
    inverse_R_ = inverse_sqrt(R2);
    at_R_ = switching(R2 * inverse_R_);
  }
  [[gnu::always_inline]] void apply_to(PairLoad<Real>& load) const {
    load.f =
        at_R_.w * load.f - (at_R_.slope * (load.van_der_waals + load.coulomb) * inverse_R_) * R_;
    load.tau_b = at_R_.w * load.tau_b;
    load.van_der_waals = at_R_.w * load.van_der_waals;
    load.coulomb = at_R_.w * load.coulomb;
  }

 private:
  const Vec3<Real>& R_;
  Real inverse_R_;
  typename Switch<T>::template Value<Real> at_R_;  // w(R) and w'(R)
};

/// All sites a of the first molecule with a few sites b of the second. Each step is done for all
/// pairs before the next begins, so that no operation waits for the result of the one before.
template <CutoffTreatment treatment, bool energies, class Shape, class Real>
class SitePairs {
 public:
  [[gnu::always_inline]] SitePairs(const Shape& shape, std::size_t first_b)
      : shape_(shape), first_b_(first_b) {}

  /// The vectors r from a to b, and 1/r, 1/r², 1/r³.
  template <class SitesOfA, class SitesOfB>
  [[gnu::always_inline]] void find_distances(const Vec3<Real>& R, const SitesOfA& site_a,
                                             const SitesOfB& site_b) {
    each_b([&](auto k, std::size_t b)
               __attribute__((always_inline)) { arm_[k] = site_b(b), f_b_[k] = {}; });
    each_pair([&](auto k, auto a, std::size_t) __attribute__((always_inline)) {
      r_[k][a] = R + arm_[k] - site_a(a);
      r2_[k][a] = norm2(r_[k][a]);
    });
    each_pair([&](auto k, auto a, std::size_t) __attribute__((always_inline)) {
      inverse_r_[k][a] = InversePowers<Real>(r2_[k][a]);
    });
  }

  /// The polynomial subtracted from 1/r, and its −u'/r, by Horner's rule in y = 1 − r²/a².
  template <class T>
  [[gnu::always_inline]] void find_polynomials(const SmoothPart<T>& law) {
    each_charged([&](auto k, auto a) __attribute__((always_inline)) {
      y_[k][a] = C(1) - r2_[k][a] * C(law.inverse_a2);
      smooth_u_[k][a] = Polynomial<Real>(C(law.u[law.degree + 1]));
      smooth_s_[k][a] = Polynomial<Real>(C(law.s[law.degree]));
    });
    for (int n = law.degree; n-- > 0;)
      each_charged([&](auto k, auto a) __attribute__((always_inline)) {
        smooth_s_[k][a].step(y_[k][a], C(law.s[n]));
      });
    if constexpr (need_u)
      for (int n = law.degree + 1; n-- > 0;)
        each_charged([&](auto k, auto a) __attribute__((always_inline)) {
          smooth_u_[k][a].step(y_[k][a], C(law.u[n]));
        });
  }

  /// −u'/r of each pair, summed over its laws; adds up the energies if they are needed.
  template <class Law, class T>
  [[gnu::always_inline]] void apply_laws(const PairStrengths<Law>& strengths,
                                         const PairLaws<T>& laws, PairLoad<Real>& load) {
    each_pair([&](auto k, auto a, std::size_t b) __attribute__((always_inline)) {
      const SiteTruncation<treatment, Real, T> truncated(laws, inverse_r_[k][a], r2_[k][a]);
      const std::size_t pair = b * shape_.sites_a + a;
      const auto coulomb = [&]() __attribute__((always_inline)) {
        const PairValue<Real> value = coulomb_of(k, a, C(strengths.charge[pair]), truncated, laws);
        if constexpr (need_u) load.coulomb += value.u;
        return value.s;
      };
      const auto short_range = [&]() __attribute__((always_inline)) {
        const PairValue<Real> value = truncated(strengths.law[pair]);
        if constexpr (need_u) load.van_der_waals += value.u;
        return value.s;
      };
      s_[k][a] = !shape_.short_range(a, b) ? coulomb()
                 : !shape_.coulomb(a, b)   ? short_range()
                                           : coulomb() + short_range();
    });
  }

  /// The force s r of each pair acts on b's sites: their sum, and its torque about b's centre.
  [[gnu::always_inline]] void add_forces(PairLoad<Real>& load) {
    each_pair([&](auto k, auto a, std::size_t)
                  __attribute__((always_inline)) { add_scaled(f_b_[k], s_[k][a], r_[k][a]); });
    each_b([&](auto k, std::size_t) __attribute__((always_inline)) {
      load.f += f_b_[k];
      add_cross(load.tau_b, arm_[k], f_b_[k]);
    });
  }

 private:
  using C = Constant<Real>;
  static constexpr std::size_t at_once = Shape::template at_once<Real>;
  static constexpr bool need_u = energies || treatment == CutoffTreatment::molecule_switch;
  template <class Number>
  using PerPair = std::array<std::array<Number, Shape::max_a>, at_once>;

  template <class Body>
  [[gnu::always_inline]] void each_b(const Body& body) const {  // body(k, b), b the k-th site
    for (std::size_t k = 0; k < at_once; ++k)
      if (first_b_ + k < shape_.sites_b) body(k, first_b_ + k);
  }
  template <class Body>
  [[gnu::always_inline]] void each_pair(const Body& body) const {  // body(k, a, b)
    for (std::size_t k = 0; k < at_once; ++k)
      for (std::size_t a = 0; a < shape_.sites_a; ++a)
        if (const std::size_t b = first_b_ + k;
            b < shape_.sites_b && (shape_.coulomb(a, b) || shape_.short_range(a, b)))
          body(k, a, b);
  }
  template <class Body>
  [[gnu::always_inline]] void each_charged(const Body& body) const {  // body(k, a)
    each_pair([&](auto k, auto a, std::size_t b) __attribute__((always_inline)) {
      if (shape_.coulomb(a, b)) body(k, a);
    });
  }

  // K q q (1/r − P(r)) up to the cutoff if a polynomial P is subtracted, otherwise K q q (1/r + k
  // r² − c), truncated.
  template <class Truncation, class T>
  [[gnu::always_inline]] PairValue<Real> coulomb_of(std::size_t k, std::size_t a, C charge,
                                                    const Truncation& truncated,
                                                    const PairLaws<T>& laws) const {
    if constexpr (is_smooth(treatment)) {
      Real u = inverse_r_[k][a].first() - smooth_u_[k][a].value(y_[k][a]);
      Real s = inverse_r_[k][a].third() - smooth_s_[k][a].value(y_[k][a]);
      if constexpr (treatment == CutoffTreatment::smooth) {
        const auto within = r2_[k][a] < Real(laws.cutoff * laws.cutoff);
        u = select(within, u, Real(0));
        s = select(within, s, Real(0));
      }
      return {charge * u, charge * s};
    } else {
      return truncated([&]<class Number>(const InversePowers<Number>& inverse_r, Number r2)
                           __attribute__((always_inline)) {
                             const PairValue<Number> unit = laws.reaction_field(inverse_r, r2);
                             return PairValue<Number>{charge * unit.u, charge * unit.s};
                           });
    }
  }

  const Shape& shape_;
  std::size_t first_b_;
  std::array<Vec3<Real>, at_once> arm_, f_b_;  // from b's centre; the force on the site
  PerPair<Vec3<Real>> r_;
  PerPair<Real> r2_, s_, y_;
  PerPair<InversePowers<Real>> inverse_r_;
  PerPair<Polynomial<Real>> smooth_u_, smooth_s_;
};

/// Sums over the site pairs of molecules a and b. The cutoff treatments are
///
/// `molecule_switch`:  U = w(R) Σ u(r), R the distance between the centres of mass
/// `site_switch`:      U = Σ w(r) u(r)
/// `site_shift`:       U = Σ [u(r) − u(r_c) − (r − r_c) u'(r_c)] for r < r_c
///
/// with u = u_short + K q q (1/r + k r² − c), where u_short is the short-range law of the two
/// sites, and k and c describe the reaction field, and
///
/// `smooth`:           U = Σ w(r) u_short(r) + K q q (1/r − P(r)) for r < r_c, P the
/// SmoothPolynomial
///
/// @tparam energies  whether energies are computed; the forces are the same either way
/// @param R       vector from the centre of a to that of b, with its periodic image [nm]
/// @param site_a  callable: position of the k-th site of a relative to a's centre, lab frame [nm]
/// @param site_b  the same for b, relative to b's centre
template <CutoffTreatment treatment, bool energies, class Shape, class Real, class Law, class T,
          class SitesOfA, class SitesOfB>
[[gnu::always_inline]] inline PairLoad<Real> molecule_pair(
    const Shape& shape, const PairStrengths<Law>& strengths, const PairLaws<T>& laws,
    const Vec3<Real>& R, const SitesOfA& site_a, const SitesOfB& site_b) {
  constexpr std::size_t at_once = Shape::template at_once<Real>;
  const auto sum_over_sites = [&]() __attribute__((always_inline)) {
    PairLoad<Real> load;
    each(
        shape.groups_b(Count<at_once>{}), [&](auto group) __attribute__((always_inline)) {
          SitePairs<treatment, energies, Shape, Real> pairs(shape, group * at_once);
          pairs.find_distances(R, site_a, site_b);
          if constexpr (is_smooth(treatment)) pairs.find_polynomials(laws.smooth);
          pairs.apply_laws(strengths, laws, load);
          pairs.add_forces(load);
        });
    return load;
  };
  if constexpr (treatment == CutoffTreatment::molecule_switch) {
    const MoleculeSwitch<Real, T> switched(laws.switching, R);
    PairLoad<Real> load = sum_over_sites();
    switched.apply_to(load);
    return load;
  } else {
    return sum_over_sites();
  }
}

}  // namespace polhode
