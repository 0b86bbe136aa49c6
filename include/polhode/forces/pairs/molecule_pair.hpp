// SPDX-License-Identifier: MIT
// The interaction of two rigid molecules: the sum over all pairs of their sites, truncated smoothly
// at the cutoff. Written once as a template over the number type: plain numbers, packs (one
// molecule with several partners at once, one in each lane) and dual numbers of either, which also
// give the derivative of forces and torques along a displacement of the molecules.
#pragma once

#include <algorithm>
#include <array>

#include "polhode/base/unroll.hpp"
#include "polhode/forces/laws/laws.hpp"
#include "polhode/forces/pairs/pair_table.hpp"
#include "polhode/math/polynomial.hpp"

namespace polhode {

/// Cutoff treatment of the pairs of a loop. `none` and `smooth_untruncated` are for molecules known
/// to lie inside the switching distance, where nothing is truncated. With `smooth` (PME, damped
/// shifted force) the Coulomb energy vanishes at the cutoff by itself, because a polynomial is
/// subtracted from 1/r, and Lennard-Jones is switched site by site.
enum class CutoffTreatment {
  none,
  molecule_switch,
  site_switch,
  site_shift,
  smooth_untruncated,
  smooth
};

constexpr bool is_smooth(CutoffTreatment treatment) {
  return treatment == CutoffTreatment::smooth || treatment == CutoffTreatment::smooth_untruncated;
}
/// The treatment of pairs inside the switching distance: the same laws without truncation.
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

/// Force and torque that molecule a exerts on molecule b; the force on a is −f.
template <class Real>
struct PairLoad {
  Vec3<Real> f{};                   ///< force on b [kJ/mol/nm]
  Vec3<Real> tau_b{};               ///< torque on b about its centre [kJ/mol]
  Real lennard_jones{}, coulomb{};  ///< [kJ/mol]; only if requested

  /// Torque on a about its centre [kJ/mol]. Every force acts along the line between two sites or
  /// between the centres, so the torques about any common point cancel: tau_a + tau_b + R × f = 0.
  /// If all sites are at the centre, the result is 0 only to rounding.
  Vec3<Real> tau_a(const Vec3<Real>& R) const { return -(tau_b + cross(R, f)); }
};

/// The numbers of sites of two molecules as compile-time constants, so that the loops over sites
/// unroll. Sites are in the order of InteractionSites.
template <std::size_t sites_a_, std::size_t charged_a_, std::size_t dispersive_a_,
          std::size_t sites_b_ = sites_a_, std::size_t charged_b_ = charged_a_,
          std::size_t dispersive_b_ = dispersive_a_>
struct FixedShape {
  static constexpr Count<sites_a_> sites_a{};
  static constexpr Count<sites_b_> sites_b{};
  static constexpr std::size_t max_a = sites_a_, max_b = sites_b_;
  /// How many sites of b are processed together: enough to hide the latency of each operation, and
  /// few enough to stay in registers, of which dual numbers need twice as many.
  template <class Real>
  static constexpr std::size_t at_once = is_dual<Real> ? 1 : std::min<std::size_t>(2, sites_b_);
  static constexpr bool coulomb(std::size_t a, std::size_t b) {
    return a < charged_a_ && b < charged_b_;
  }
  static constexpr bool lennard_jones(std::size_t a, std::size_t b) {
    return a >= sites_a_ - dispersive_a_ && b >= sites_b_ - dispersive_b_;
  }
  template <std::size_t size>
  static constexpr Count<(sites_b_ + size - 1) / size> groups_b(Count<size>) {
    return {};
  }
  explicit FixedShape(const PairTable&) {}
  static bool fits(const PairTable& t) {
    return t.sites_a == sites_a_ && t.sites_b == sites_b_ && t.charged_a == charged_a_ &&
           t.charged_b == charged_b_ && t.dispersive_a == dispersive_a_ &&
           t.dispersive_b == dispersive_b_;
  }
};

/// Numbers of sites known only at run time.
struct AnyShape {
  static constexpr std::size_t max_a = max_sites, max_b = max_sites;
  template <class Real>
  static constexpr std::size_t at_once = 1;
  std::size_t sites_a, sites_b, charged_a, charged_b, first_dispersive_a, first_dispersive_b;
  explicit AnyShape(const PairTable& t)
      : sites_a(t.sites_a),
        sites_b(t.sites_b),
        charged_a(t.charged_a),
        charged_b(t.charged_b),
        first_dispersive_a(t.sites_a - t.dispersive_a),
        first_dispersive_b(t.sites_b - t.dispersive_b) {}
  std::size_t groups_b(Count<1>) const { return sites_b; }
  bool coulomb(std::size_t a, std::size_t b) const { return a < charged_a && b < charged_b; }
  bool lennard_jones(std::size_t a, std::size_t b) const {
    return a >= first_dispersive_a && b >= first_dispersive_b;
  }
};

/// Shifted-force energy and force of a pair of sites: u(r) − u(r_c) − (r − r_c) u'(r_c)
/// for r < r_c, zero beyond [toxvaerd2011].
template <class Real>
PairValue<Real> shifted_force(const PairValue<Real>& at_r,
                              const PairValue<Constant<Real>>& at_cutoff, Real r, Real inverse_r,
                              Constant<Real> rc) {
  const auto within = r < Real(rc);
  const Constant<Real> f = at_cutoff.s * rc;  // −u'(r_c)
  return {select(within, at_r.u - at_cutoff.u + (r - rc) * f, Real(0)),
          select(within, at_r.s - f * inverse_r, Real(0))};
}

/// Sums over the site pairs of molecules a and b. The cutoff treatments are
///
/// `molecule_switch`:  U = w(R) Σ u(r), R the distance between the centres of mass
/// `site_switch`:      U = Σ w(r) u(r)
/// `site_shift`:       U = Σ [u(r) − u(r_c) − (r − r_c) u'(r_c)] for r < r_c
///
/// with u = u_LJ + K q q (1/r + k r² − c), where k and c describe the reaction field, and
///
/// `smooth`:           U = Σ w(r) u_LJ(r) + K q q (1/r − P(r)) for r < r_c, P the SmoothPolynomial
///
/// @tparam energies  whether energies are computed; the forces are the same either way
/// @param R       vector from the centre of a to that of b, with its periodic image [nm]
/// @param site_a  callable: position of the k-th site of a relative to a's centre, lab frame [nm]
/// @param site_b  the same for b, relative to b's centre
template <CutoffTreatment treatment, bool energies, class Shape, class Real, class T,
          class SitesOfA, class SitesOfB>
[[gnu::always_inline]] inline PairLoad<Real> molecule_pair(
    const Shape& shape, const PairStrengths<T>& strengths, const PairLaws<T>& laws,
    const Vec3<Real>& R, const SitesOfA& site_a, const SitesOfB& site_b) {
  using C = Constant<Real>;
  constexpr bool by_molecule = treatment == CutoffTreatment::molecule_switch;
  constexpr bool by_site =
      treatment == CutoffTreatment::site_switch || treatment == CutoffTreatment::smooth;
  constexpr bool need_u = energies || treatment == CutoffTreatment::molecule_switch;
  PairLoad<Real> load;
  typename Switch<T>::template Value<Real> switch_at_R{};  // w(R) and w'(R) of the molecule switch
  Real inverse_R{};
  if constexpr (by_molecule) {
    const Real R2 = norm2(R);
    inverse_R = inverse_sqrt(R2);
    switch_at_R = laws.switching(R2 * inverse_R);
  }

  // Sites of b are processed in groups of `at_once`; k numbers the sites of a group. each_b calls
  // body(k, b) for each site of b, each_pair calls body(k, a, b) for each interacting pair.
  constexpr std::size_t at_once = Shape::template at_once<Real>;
  each(
      shape.groups_b(Count<at_once>{}), [&](auto group) __attribute__((always_inline)) {
        std::array<Vec3<Real>, at_once> arm, f_b;
        std::array<std::array<Vec3<Real>, Shape::max_a>, at_once> r;  // from a's site to b's
        std::array<std::array<Real, Shape::max_a>, at_once> r2, s;
        std::array<std::array<InversePowers<Real>, Shape::max_a>, at_once> inverse_r;
        const auto each_b = [&](const auto& body) __attribute__((always_inline)) {
          for (std::size_t k = 0; k < at_once; ++k)
            if (group * at_once + k < shape.sites_b) body(k, group * at_once + k);
        };
        const auto each_pair = [&](const auto& body) __attribute__((always_inline)) {
          for (std::size_t k = 0; k < at_once; ++k)
            for (std::size_t a = 0; a < shape.sites_a; ++a)
              if (const std::size_t b = group * at_once + k;
                  b < shape.sites_b && (shape.coulomb(a, b) || shape.lennard_jones(a, b)))
                body(k, a, b);
        };

        // Site-site vectors, their squares, and the negative powers of the distances.
        each_b([&](auto k, std::size_t b)
                   __attribute__((always_inline)) { arm[k] = site_b(b), f_b[k] = {}; });
        each_pair([&](auto k, auto a, std::size_t) __attribute__((always_inline)) {
          r[k][a] = R + arm[k] - site_a(a);
          r2[k][a] = norm2(r[k][a]);
        });
        each_pair([&](auto k, auto a, std::size_t) __attribute__((always_inline)) {
          inverse_r[k][a] = InversePowers<Real>(r2[k][a]);
        });
        std::array<std::array<Real, Shape::max_a>, at_once> y;
        std::array<std::array<Polynomial<Real>, Shape::max_a>, at_once> smooth_u,
            smooth_s;  // in y
        // Charges: u and −u'/r of the polynomial subtracted from 1/r, by Horner's rule in
        // y = 1 − r²/a². All pairs of the group take one step at a time, so that no step has to
        // wait for the previous one.
        if constexpr (is_smooth(treatment)) {
          const SmoothPart<T>& law = laws.smooth;
          const auto each_charged = [&](const auto& body) __attribute__((always_inline)) {
            each_pair([&](auto k, auto a, std::size_t b) __attribute__((always_inline)) {
              if (shape.coulomb(a, b)) body(k, a);
            });
          };
          each_charged([&](auto k, auto a) __attribute__((always_inline)) {
            y[k][a] = C(1) - r2[k][a] * C(law.inverse_a2);
            smooth_u[k][a] = Polynomial<Real>(C(law.u[law.degree + 1]));
            smooth_s[k][a] = Polynomial<Real>(C(law.s[law.degree]));
          });
          for (int n = law.degree; n-- > 0;)
            each_charged([&](auto k, auto a) __attribute__((always_inline)) {
              smooth_s[k][a].step(y[k][a], C(law.s[n]));
            });
          if constexpr (need_u)
            for (int n = law.degree + 1; n-- > 0;)
              each_charged([&](auto k, auto a) __attribute__((always_inline)) {
                smooth_u[k][a].step(y[k][a], C(law.u[n]));
              });
        }
        // The sum of −u'/r over the laws of each pair, and the energies if needed.
        each_pair([&](auto k, auto a, std::size_t b) __attribute__((always_inline)) {
          const InversePowers<Real>& inverse = inverse_r[k][a];
          const Real square = r2[k][a];
          const std::size_t pair = b * shape.sites_a + a;
          typename Switch<T>::template Value<Real> site_switch_at_r{};
          if constexpr (by_site) site_switch_at_r = laws.switching(square * inverse.first());
          // A law with its cutoff treatment: switched, shifted, or unchanged.
          const auto truncate = [&](PairValue<Real> at_r, const auto& at_cutoff)
              __attribute__((always_inline)) {
            at_r = with_derivative(at_r, square);
            if constexpr (by_site) {  // −(w u)'/r = w s − w' u/r
              at_r.s =
                  site_switch_at_r.w * at_r.s - site_switch_at_r.slope * inverse.first() * at_r.u;
              at_r.u = site_switch_at_r.w * at_r.u;
            } else if constexpr (treatment == CutoffTreatment::site_shift) {
              const Real one_over_r = inverse.first();
              at_r =
                  shifted_force(at_r, at_cutoff(), square * one_over_r, one_over_r, C(laws.cutoff));
            }
            return with_derivative(at_r, square);
          };
          const C cutoff2(laws.cutoff * laws.cutoff);
          const auto coulomb = [&]() __attribute__((always_inline)) {
            const C charge(strengths.charge[pair]);
            if constexpr (is_smooth(treatment)) {
              PairValue<Real> value{inverse.first() - smooth_u[k][a].value(y[k][a]),
                                    inverse.third() - smooth_s[k][a].value(y[k][a])};
              if constexpr (treatment == CutoffTreatment::smooth) {
                const auto within = square < Real(laws.cutoff * laws.cutoff);
                value = {select(within, value.u, Real(0)), select(within, value.s, Real(0))};
              }
              if constexpr (need_u) load.coulomb += charge * value.u;
              return charge * value.s;
            } else {
              const auto law = [&]<class Number>(const InversePowers<Number>& powers,
                                                 Number r_squared) __attribute__((always_inline)) {
                const PairValue<Number> unit = laws.reaction_field(powers, r_squared);
                return PairValue<Number>{charge * unit.u, charge * unit.s};
              };
              const PairValue<Real> value = truncate(
                  law(inverse, square), [&] { return law(InversePowers<C>(cutoff2), cutoff2); });
              if constexpr (need_u) load.coulomb += value.u;
              return value.s;
            }
          };
          const auto lennard_jones = [&]() __attribute__((always_inline)) {
            const C c6(strengths.c6[pair]), c12(strengths.c12[pair]);
            const PairValue<Real> value = truncate(
                LennardJones::of(c6, c12, inverse.second()),
                [&] { return LennardJones::of(c6, c12, C(1 / (laws.cutoff * laws.cutoff))); });
            if constexpr (need_u) load.lennard_jones += value.u;
            return value.s;
          };
          s[k][a] = !shape.lennard_jones(a, b) ? coulomb()
                    : !shape.coulomb(a, b)     ? lennard_jones()
                                               : coulomb() + lennard_jones();
        });
        // Forces on the sites of b, then the force and the torque on b.
        each_pair([&](auto k, auto a, std::size_t)
                      __attribute__((always_inline)) { add_scaled(f_b[k], s[k][a], r[k][a]); });
        each_b([&](auto k, std::size_t) __attribute__((always_inline)) {
          load.f += f_b[k];
          add_cross(load.tau_b, arm[k], f_b[k]);
        });
      });

  if constexpr (by_molecule) {  // U = w(R) u: forces w s between sites, −w'(R) u between centres
    load.f = switch_at_R.w * load.f -
             (switch_at_R.slope * (load.lennard_jones + load.coulomb) * inverse_R) * R;
    load.tau_b = switch_at_R.w * load.tau_b;
    load.lennard_jones = switch_at_R.w * load.lennard_jones;
    load.coulomb = switch_at_R.w * load.coulomb;
  }
  return load;
}

}  // namespace polhode
