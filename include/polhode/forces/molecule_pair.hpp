// SPDX-License-Identifier: MIT
// The interaction of two rigid molecules: all pairs of their sites, ended smoothly at the cutoff.
// Written once for numbers, packs (one molecule with several partners) and dual numbers.
#pragma once

#include <array>

#include "polhode/base/unroll.hpp"
#include "polhode/forces/laws.hpp"
#include "polhode/forces/pair_table.hpp"

namespace polhode {

/// How the pairs at hand end: as the force field's truncation says, or not at all, for molecules
/// that are known to be closer than where any switch begins.
enum class Ending { none, molecule_switch, site_switch, site_shift };

constexpr Ending ending_of(Truncation truncation) {
  return truncation == Truncation::molecule_switch ? Ending::molecule_switch
         : truncation == Truncation::site_switch   ? Ending::site_switch
                                                   : Ending::site_shift;
}

/// What molecule a does to molecule b; b does the opposite force to a.
template <class Real>
struct PairLoad {
  Vec3<Real> f{};                   ///< force on b [kJ/mol/nm]
  Vec3<Real> tau_b{};               ///< torque on b about its centre [kJ/mol]
  Real lennard_jones{}, coulomb{};  ///< [kJ/mol]; only where they are wanted
};

/// The sites of two molecules, their numbers known when the loops over them are compiled: these
/// unroll. Sites stand in the order of InteractionSites.
template <std::size_t sites_a_, std::size_t charged_a_, std::size_t dispersive_a_,
          std::size_t sites_b_ = sites_a_, std::size_t charged_b_ = charged_a_,
          std::size_t dispersive_b_ = dispersive_a_>
struct FixedShape {
  static constexpr Count<sites_a_> sites_a{};
  static constexpr Count<sites_b_> sites_b{};
  static constexpr std::size_t most_a = sites_a_, most_b = sites_b_;
  static constexpr bool coulomb(std::size_t a, std::size_t b) {
    return a < charged_a_ && b < charged_b_;
  }
  static constexpr bool lennard_jones(std::size_t a, std::size_t b) {
    return a >= sites_a_ - dispersive_a_ && b >= sites_b_ - dispersive_b_;
  }
  explicit FixedShape(const PairTable&) {}
  static bool fits(const PairTable& t) {
    return t.sites_a == sites_a_ && t.sites_b == sites_b_ && t.charged_a == charged_a_ &&
           t.charged_b == charged_b_ && t.dispersive_a == dispersive_a_ &&
           t.dispersive_b == dispersive_b_;
  }
};

/// Any numbers of sites.
struct AnyShape {
  static constexpr std::size_t most_a = most_sites, most_b = most_sites;
  std::size_t sites_a, sites_b, charged_a, charged_b, first_dispersive_a, first_dispersive_b;
  explicit AnyShape(const PairTable& t)
      : sites_a(t.sites_a),
        sites_b(t.sites_b),
        charged_a(t.charged_a),
        charged_b(t.charged_b),
        first_dispersive_a(t.sites_a - t.dispersive_a),
        first_dispersive_b(t.sites_b - t.dispersive_b) {}
  bool coulomb(std::size_t a, std::size_t b) const { return a < charged_a && b < charged_b; }
  bool lennard_jones(std::size_t a, std::size_t b) const {
    return a >= first_dispersive_a && b >= first_dispersive_b;
  }
};

/// Energy and force of a pair of sites, less what they are at the cutoff: u(r) − u(r_c) −
/// (r − r_c) u'(r_c), and nothing beyond it [toxvaerd2011].
template <class Real>
PairValue<Real> shifted(const PairValue<Real>& at_r, const PairValue<Real>& at_cutoff, Real r,
                        Real inverse_r, Real rc) {
  const auto within = r < rc;
  const Real f = at_cutoff.s * rc;  // −u'(r_c)
  return {select(within, at_r.u - at_cutoff.u + (r - rc) * f, Real(0)),
          select(within, at_r.s - f * inverse_r, Real(0))};
}

/// Sums over the site pairs of molecules a and b.
///
/// `molecule_switch`:  U = w(R) Σ u(r), R the distance of the centres of mass
/// `site_switch`:      U = Σ w(r) u(r)
/// `site_shift`:       U = Σ [u(r) − u(r_c) − (r − r_c) u'(r_c)] for r < r_c
///
/// with u = u_LJ + K q q (1/r + k r² − c).
///
/// @tparam energies  whether the energies are wanted; forces never depend on that
/// @param R       centre of b relative to that of a [nm], the image meant
/// @param site_a  a callable: the k-th site of a relative to a's centre, lab frame [nm]
/// @param site_b  the same of b, relative to b's
/// @param f_a     what each site of a does to b is added to these [kJ/mol/nm]
template <Ending ending, bool energies, class Shape, class Real, class T, class SitesOfA,
          class SitesOfB>
[[gnu::always_inline]] inline PairLoad<Real> molecule_pair(
    const Shape& shape, const PairStrengths<T>& strengths, const PairLaws<T>& laws,
    const Vec3<Real>& R, const SitesOfA& site_a, const SitesOfB& site_b, Vec3<Real>* f_a) {
  constexpr bool by_molecule = ending == Ending::molecule_switch;
  constexpr bool need_u = energies || ending != Ending::none;
  PairLoad<Real> load;
  typename Switch<T>::template Value<Real> end{};  // of the whole pair
  Real inverse_R{};
  if constexpr (by_molecule) {
    const Real R2 = norm2(R);
    inverse_R = inverse_sqrt(R2);
    end = laws.switching(R2 * inverse_R);
  }

  each(
      shape.sites_b, [&](auto b) __attribute__((always_inline)) {
        const Vec3<Real> arm_b = site_b(b), at_b = R + arm_b;
        std::array<Vec3<Real>, Shape::most_a> r;  // from each site of a to b's
        std::array<Real, Shape::most_a> r2, s;
        std::array<InversePowers<Real>, Shape::most_a> inverse_r;
        const auto each_a = [&](const auto& body) __attribute__((always_inline)) {
          each(
              shape.sites_a, [&](auto a) __attribute__((always_inline)) {
                if (shape.coulomb(a, b) || shape.lennard_jones(a, b)) body(a);
              });
        };
        each_a([&](auto a) __attribute__((always_inline)) {
          r[a] = at_b - site_a(a);
          r2[a] = norm2(r[a]);
        });
        each_a([&](auto a)
                   __attribute__((always_inline)) { inverse_r[a] = InversePowers<Real>(r2[a]); });
        each_a([&](auto a) __attribute__((always_inline)) {
          const std::size_t pair = b * shape.sites_a + a;
          typename Switch<T>::template Value<Real> site_end{};
          if constexpr (ending == Ending::site_switch)
            site_end = laws.switching(r2[a] * inverse_r[a].first());
          const auto ended = [&](PairValue<Real> at_r, const auto& at_cutoff)
              __attribute__((always_inline)) {
            if constexpr (by_molecule) {
              at_r.s = end.w * at_r.s;
            } else if constexpr (ending == Ending::site_switch) {  // −(w u)'/r = w s − w' u/r
              at_r.s = site_end.w * at_r.s - site_end.slope * inverse_r[a].first() * at_r.u;
              at_r.u = site_end.w * at_r.u;
            } else if constexpr (ending == Ending::site_shift) {
              const Real inverse = inverse_r[a].first();
              at_r = shifted(at_r, at_cutoff(), r2[a] * inverse, inverse, Real(laws.cutoff));
            }
            return at_r;
          };
          const auto coulomb = [&]() __attribute__((always_inline)) {
            const Real charge(strengths.charge[pair]);
            const auto law = [&](const InversePowers<Real>& inverse, Real square)
                __attribute__((always_inline)) {
              const PairValue<Real> unit = laws.reaction_field(inverse, square);
              return PairValue<Real>{charge * unit.u, charge * unit.s};
            };
            const PairValue<Real> value = ended(law(inverse_r[a], r2[a]), [&] {
              const Real square(laws.cutoff * laws.cutoff);
              return law(InversePowers<Real>(square), square);
            });
            if constexpr (need_u) load.coulomb += value.u;
            return value.s;
          };
          const auto lennard_jones = [&]() __attribute__((always_inline)) {
            const Real c6(strengths.c6[pair]), c12(strengths.c12[pair]);
            const PairValue<Real> value = ended(
                LennardJones::of(c6, c12, inverse_r[a].second()),
                [&] { return LennardJones::of(c6, c12, Real(1 / (laws.cutoff * laws.cutoff))); });
            if constexpr (need_u) load.lennard_jones += value.u;
            return value.s;
          };
          s[a] = !shape.lennard_jones(a, b) ? coulomb()
                 : !shape.coulomb(a, b)     ? lennard_jones()
                                            : coulomb() + lennard_jones();
        });
        Vec3<Real> f_b{};
        each_a([&](auto a) __attribute__((always_inline)) {
          const Vec3<Real> f = s[a] * r[a];
          f_b += f;
          f_a[a] += f;
        });
        load.f += f_b;
        load.tau_b += cross(arm_b, f_b);
      });

  if constexpr (by_molecule) {  // U = w(R) u: beside w s on all sites, −w'(R) u between the centres
    load.f -= (end.slope * (load.lennard_jones + load.coulomb) * inverse_R) * R;
    load.lennard_jones = end.w * load.lennard_jones;
    load.coulomb = end.w * load.coulomb;
  }
  return load;
}

}  // namespace polhode
