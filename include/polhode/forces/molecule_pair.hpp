// SPDX-License-Identifier: MIT
// The interaction of two rigid molecules: all pairs of their sites, ended smoothly at the cutoff.
// Written once for numbers, packs (one molecule with several partners) and dual numbers.
#pragma once

#include "polhode/forces/laws.hpp"
#include "polhode/forces/pair_table.hpp"

namespace polhode {

/// What molecule a does to molecule b; b does the opposite force, and tau_a, to a.
template <class Real>
struct PairLoad {
  Vec3<Real> f{};                         ///< force on b [kJ/mol/nm]
  Vec3<Real> tau_b{};                     ///< torque on b about its centre [kJ/mol]
  Vec3<Real> tau_a{};                     ///< torque on a about its centre [kJ/mol]
  Real lennard_jones{0.0}, coulomb{0.0};  ///< [kJ/mol]
};

/// Sums over the site pairs of molecules a and b.
///
/// `molecule_switch`:  U = w(R) Σ [u_LJ(r) + K q q/r], R the distance of the centres of mass
/// `reaction_field`:   U = Σ w(r) [u_LJ(r) + K q q (1/r + k r² − c)]
///
/// @param R      centre of b relative to that of a [nm], the image meant
/// @param arm_a  sites of a relative to its centre, lab frame [nm]
/// @param arm_b  the same of b
template <Truncation truncation, class Real>
PairLoad<Real> molecule_pair(const PairTable& table, const PairLaws& laws, const Vec3<Real>& R,
                             const Vec3<Real>* arm_a, const Vec3<Real>* arm_b) {
  constexpr bool by_site = truncation == Truncation::reaction_field;
  PairLoad<Real> load;
  for (std::size_t b = 0; b < table.sites_b; ++b) {
    const Vec3<Real> at_b = R + arm_b[b];
    Vec3<Real> f_b{};
    for (const PairTable::Term& term : table.of_b[b]) {
      const Vec3<Real> r = at_b - arm_a[term.a];
      const Real r2 = norm2(r);
      if (by_site && !any(r2 < Real(laws.cutoff2))) continue;  // saves time where w is 0 anyway
      const Real inverse_r = inverse_sqrt(r2);
      const Real inverse_r2 = inverse_r * inverse_r;
      Real u_lj(0.0), u_coulomb(0.0), s(0.0);
      if (term.dispersive) {
        const PairValue<Real> lj = term.lennard_jones(inverse_r2);
        u_lj = lj.u;
        s = lj.s;
      }
      if (term.charged) {
        const PairValue<Real> coulomb = laws.reaction_field(inverse_r, r2);
        u_coulomb = Real(term.charges) * coulomb.u;
        s += Real(term.charges) * coulomb.s;
      }
      if (by_site && any(r2 > Real(laws.from2))) {  // −(w u)'/r = w s − w' u/r
        const Switch::Value<Real> end = laws.switching(r2 * inverse_r);
        s = end.w * s - end.slope * inverse_r * (u_lj + u_coulomb);
        u_lj = end.w * u_lj;
        u_coulomb = end.w * u_coulomb;
      }
      load.lennard_jones += u_lj;
      load.coulomb += u_coulomb;
      const Vec3<Real> f = s * r;
      f_b += f;
      load.tau_a -= cross(arm_a[term.a], f);
    }
    load.f += f_b;
    load.tau_b += cross(arm_b[b], f_b);
  }
  if constexpr (!by_site) {  // U = w(R) u: w scales all, and −w'(R) u acts between the centres
    const Real distance = sqrt(norm2(R));
    const Switch::Value<Real> end = laws.switching(distance);
    const Real u = load.lennard_jones + load.coulomb;
    load.f = end.w * load.f - (end.slope * u / distance) * R;
    load.tau_a *= end.w;
    load.tau_b *= end.w;
    load.lennard_jones = end.w * load.lennard_jones;
    load.coulomb = end.w * load.coulomb;
  }
  return load;
}

}  // namespace polhode
