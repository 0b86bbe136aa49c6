// SPDX-License-Identifier: MIT
// The interaction of two rigid molecules: all pairs of their sites, ended smoothly at the cutoff.
// Written once for numbers, packs (one molecule with several partners) and dual numbers.
#pragma once

#include <array>

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

/// How many sites of each kind two molecules have. Numbers that are known when the loops over them
/// are compiled, as for water with water, let these unroll.
template <std::size_t charged_a_, std::size_t charged_b_, std::size_t dispersive_a_,
          std::size_t dispersive_b_>
struct FixedShape {
  static constexpr std::size_t charged_a = charged_a_, charged_b = charged_b_;
  static constexpr std::size_t dispersive_a = dispersive_a_, dispersive_b = dispersive_b_;
  static constexpr std::size_t most_a = charged_a + dispersive_a, most_b = charged_b + dispersive_b;
  static constexpr std::size_t most = most_a > most_b ? most_a : most_b;  ///< arms of a molecule
  explicit FixedShape(const PairTable&) {}
  static bool fits(const PairTable& t) {
    return t.charged_a == charged_a && t.charged_b == charged_b && t.dispersive_a == dispersive_a &&
           t.dispersive_b == dispersive_b;
  }
};

/// Any numbers of sites.
struct AnyShape {
  static constexpr std::size_t most = most_arms;
  std::size_t charged_a, charged_b, dispersive_a, dispersive_b;
  explicit AnyShape(const PairTable& t)
      : charged_a(t.charged_a),
        charged_b(t.charged_b),
        dispersive_a(t.dispersive_a),
        dispersive_b(t.dispersive_b) {}
};

/// Sums over the site pairs of molecules a and b.
///
/// `molecule_switch`:  U = w(R) Σ [u_LJ(r) + K q q/r], R the distance of the centres of mass
/// `reaction_field`:   U = Σ w(r) [u_LJ(r) + K q q (1/r + k r² − c)]
///
/// @param R      centre of b relative to that of a [nm], the image meant
/// @param arm_a  sites of a relative to its centre, lab frame [nm], in the order of Arms
/// @param arm_b  the same of b: a callable that yields the k-th
template <Truncation truncation, class Shape, class Real, class ArmsOfB>
PairLoad<Real> molecule_pair(const PairTable& table, const PairLaws& laws, const Vec3<Real>& R,
                             const Vec3<Real>* arm_a, const ArmsOfB& arm_b) {
  constexpr bool by_site = truncation == Truncation::reaction_field;
  const Shape shape(table);
  PairLoad<Real> load;
  std::array<Vec3<Real>, Shape::most> f_a;  // on the sites of a, less their sign
  for (std::size_t a = 0; a < shape.charged_a + shape.dispersive_a; ++a) f_a[a] = {};

  const double* charge = table.charges.data();
  for (std::size_t b = 0; b < shape.charged_b; ++b) {
    const Vec3<Real> arm = arm_b(b), at_b = R + arm;
    Vec3<Real> f_b{};
    for (std::size_t a = 0; a < shape.charged_a; ++a, ++charge) {
      const Vec3<Real> r = at_b - arm_a[a];
      const Real r2 = norm2(r), inverse_r = inverse_sqrt(r2);
      Real u, s;
      if constexpr (by_site) {
        const PairValue<Real> coulomb = laws.reaction_field(inverse_r, r2);
        const Switch::Value<Real> end = laws.switching(r2 * inverse_r);
        u = Real(*charge) * coulomb.u;  // −(w u)'/r = w s − w' u/r
        s = end.w * (Real(*charge) * coulomb.s) - end.slope * inverse_r * u;
        u = end.w * u;
      } else {
        u = Real(*charge) * inverse_r;
        s = u * (inverse_r * inverse_r);
      }
      load.coulomb += u;
      const Vec3<Real> f = s * r;
      f_b += f;
      f_a[a] += f;
    }
    load.f += f_b;
    load.tau_b += cross(arm, f_b);
  }

  const LennardJones* lj = table.lennard_jones.data();
  for (std::size_t b = 0; b < shape.dispersive_b; ++b) {
    const Vec3<Real> arm = arm_b(shape.charged_b + b), at_b = R + arm;
    Vec3<Real> f_b{};
    for (std::size_t a = shape.charged_a; a < shape.charged_a + shape.dispersive_a; ++a, ++lj) {
      const Vec3<Real> r = at_b - arm_a[a];
      const Real r2 = norm2(r), inverse_r = inverse_sqrt(r2);
      PairValue<Real> pair = (*lj)(inverse_r * inverse_r);
      if constexpr (by_site) {
        const Switch::Value<Real> end = laws.switching(r2 * inverse_r);
        pair = {end.w * pair.u, end.w * pair.s - end.slope * inverse_r * pair.u};
      }
      load.lennard_jones += pair.u;
      const Vec3<Real> f = pair.s * r;
      f_b += f;
      f_a[a] += f;
    }
    load.f += f_b;
    load.tau_b += cross(arm, f_b);
  }
  for (std::size_t a = 0; a < shape.charged_a + shape.dispersive_a; ++a)
    load.tau_a -= cross(arm_a[a], f_a[a]);

  if constexpr (!by_site) {  // U = w(R) u: w scales all, and −w'(R) u acts between the centres
    const Real R2 = norm2(R), inverse_R = inverse_sqrt(R2);
    const Switch::Value<Real> end = laws.switching(R2 * inverse_R);
    const Real u = load.lennard_jones + load.coulomb;
    load.f = end.w * load.f - (end.slope * u * inverse_R) * R;
    load.tau_a *= end.w;
    load.tau_b *= end.w;
    load.lennard_jones = end.w * load.lennard_jones;
    load.coulomb = end.w * load.coulomb;
  }
  return load;
}

}  // namespace polhode
