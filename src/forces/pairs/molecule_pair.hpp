// SPDX-License-Identifier: MIT
// The interaction of two rigid molecules: the sum over all pairs of their sites, truncated smoothly
// at the cutoff. The code is a template over the number type: plain numbers, packs, or dual numbers
// of either kind. With packs, a molecule interacts with a partner in each lane. Dual numbers also
// give the derivative of forces and torques along a displacement of the molecules.
//
// Functions that are called for each pair of molecules are inlined into the loop over pairs.
// Constants of the loop, such as the number of sites, are then known to the compiler.
#pragma once

#include <algorithm>
#include <array>

#include "base/unroll.hpp"
#include "forces/pairs/cutoff_treatment.hpp"
#include "forces/pairs/pair_table.hpp"
#include "math/dual.hpp"
#include "polhode/base/always_inline.hpp"

namespace polhode {

/// The numbers of sites of two molecules as compile-time constants, so that the loops over sites
/// unroll. Sites are in the order of InteractionSites.
template <std::size_t sites_a_, std::size_t charged_a_, std::size_t dispersive_a_,
          std::size_t sites_b_ = sites_a_, std::size_t charged_b_ = charged_a_,
          std::size_t dispersive_b_ = dispersive_a_>
struct FixedShape {
  static constexpr Count<sites_a_> sites_a{};
  static constexpr Count<sites_b_> sites_b{};
  static constexpr std::size_t max_b = sites_b_;
  /// Numbers of sites of molecules a and b that are processed together. Groups of sites that are
  /// processed together are large enough to hide the latency of each operation, and small enough to
  /// stay in registers. Dual numbers need twice as many registers.
  static constexpr std::size_t a_at_once = sites_a_;
  template <class Real>
  static constexpr std::size_t b_at_once = is_dual<Real> ? 1 : std::min<std::size_t>(2, sites_b_);
  static constexpr bool coulomb(std::size_t a, std::size_t b) {
    return a < charged_a_ && b < charged_b_;
  }
  static constexpr bool short_range(std::size_t a, std::size_t b) {
    return a >= sites_a_ - dispersive_a_ && b >= sites_b_ - dispersive_b_;
  }
  static constexpr Count<1> groups_a() { return {}; }
  template <class Real>
  static constexpr Count<(sites_b_ + b_at_once<Real> - 1) / b_at_once<Real>> groups_b() {
    return {};
  }
  explicit FixedShape(const PairTable&) {}
  static bool fits(const PairTable& t) {
    return t.sites_a == sites_a_ && t.sites_b == sites_b_ && t.charged_a == charged_a_ &&
           t.charged_b == charged_b_ && t.dispersive_a == dispersive_a_ &&
           t.dispersive_b == dispersive_b_;
  }
};

/// Numbers of sites that are known only at run time.
template <std::size_t at_once>
struct AnyShape {
  static constexpr std::size_t max_b = max_sites;
  static constexpr std::size_t a_at_once = at_once;
  template <class Real>
  static constexpr std::size_t b_at_once = 1;
  std::size_t sites_a, sites_b, charged_a, charged_b, first_dispersive_a, first_dispersive_b;
  explicit AnyShape(const PairTable& t)
      : sites_a(t.sites_a),
        sites_b(t.sites_b),
        charged_a(t.charged_a),
        charged_b(t.charged_b),
        first_dispersive_a(t.sites_a - t.dispersive_a),
        first_dispersive_b(t.sites_b - t.dispersive_b) {}
  std::size_t groups_a() const { return (sites_a + a_at_once - 1) / a_at_once; }
  template <class Real>
  std::size_t groups_b() const {
    return sites_b;
  }
  bool coulomb(std::size_t a, std::size_t b) const { return a < charged_a && b < charged_b; }
  bool short_range(std::size_t a, std::size_t b) const {
    return a >= first_dispersive_a && b >= first_dispersive_b;
  }
};

/// Force and torque that molecule a exerts on molecule b; the force on molecule a is −f.
template <class Real>
struct PairLoad {
  Vec3<Real> f{};                   ///< force on b [kJ/mol/nm]
  Vec3<Real> tau_b{};               ///< torque on molecule b about its centre [kJ/mol]
  Real van_der_waals{}, coulomb{};  ///< energies [kJ/mol], only if requested

  /// Torque on molecule a about its centre [kJ/mol]. Every force acts along the line between two
  /// sites or between the centres, so the torques about any common point cancel: tau_a + tau_b + R
  /// × f = 0. If all sites are at the centre, the result is 0 only up to round-off.
  Vec3<Real> tau_a(const Vec3<Real>& R) const { return -(tau_b + cross(R, f)); }
};

/// The molecule switch, a function of the distance between the centres of mass. The energy U = w(R)
/// u gives the forces −w u' between sites, and −w' u between the centres.
template <class Real, class T>
class MoleculeSwitch {
 public:
  POLHODE_INLINE MoleculeSwitch(const Switch<T>& switching, const Vec3<Real>& R) : R_(R) {
    const Real R2 = norm2(R);
    inverse_R_ = inverse_sqrt(R2);
    at_R_ = switching(R2 * inverse_R_);
  }
  POLHODE_INLINE void apply_to(PairLoad<Real>& load) const {
    load.f =
        at_R_.w * load.f - (at_R_.slope * (load.van_der_waals + load.coulomb) * inverse_R_) * R_;
    load.tau_b = at_R_.w * load.tau_b;
    load.van_der_waals = at_R_.w * load.van_der_waals;
    load.coulomb = at_R_.w * load.coulomb;
  }

 private:
  const Vec3<Real>& R_;
  Real inverse_R_;
  typename Switch<T>::template Value<Real> at_R_;  // switch w(R) and its derivative w'(R)
};

/// All pairs of a site in a group of the first molecule and a site in a group of the second
/// molecule. Each step of the computation is done for all pairs before the next step, which hides
/// the latency of the operations. The result of each step is a separate variable, because a
/// compiler keeps members of a class in registers less often.
template <class Shape, class Real>
class SitePairs {
 public:
  static constexpr std::size_t a_at_once = Shape::a_at_once;
  static constexpr std::size_t b_at_once = Shape::template b_at_once<Real>;
  /// A site pair, given by two sites and their indices i and k in the groups.
  struct Pair {
    std::size_t i, k, a, b;
  };
  template <class Number>
  using PerSite = std::array<Number, b_at_once>;  // number for each site, by k
  /// A number for each pair.
  template <class Number>
  struct PerPair {
    std::array<std::array<Number, a_at_once>, b_at_once> values;
    POLHODE_INLINE Number& operator[](Pair pair) { return values[pair.k][pair.i]; }
    POLHODE_INLINE const Number& operator[](Pair pair) const { return values[pair.k][pair.i]; }
  };

  POLHODE_INLINE SitePairs(const Shape& shape, std::size_t group_a, std::size_t group_b)
      : shape_(shape), first_a_(group_a * a_at_once), first_b_(group_b * b_at_once) {}

  /// Calls body(pairs) for each group of pairs.
  template <class Body>
  POLHODE_INLINE static void each_group(const Shape& shape, const Body& body) {
    polhode::each(shape.template groups_b<Real>(), [&](auto group_b) POLHODE_INLINE_LAMBDA {
      polhode::each(shape.groups_a(), [&](auto group_a) POLHODE_INLINE_LAMBDA {
        body(SitePairs(shape, group_a, group_b));
      });
    });
  }
  template <class Body>
  POLHODE_INLINE void each_b(const Body& body) const {  // Calls body(k, b) for each site b.
#pragma GCC unroll 8
    for (std::size_t k = 0; k < b_at_once; ++k)
      if (first_b_ + k < shape_.sites_b) body(k, first_b_ + k);
  }
  template <class Body>
  POLHODE_INLINE void each(const Body& body) const {  // Calls body(pair) for each pair.
#pragma GCC unroll 8
    for (std::size_t k = 0; k < b_at_once; ++k)
#pragma GCC unroll 8
      for (std::size_t i = 0; i < a_at_once; ++i)
        if (const std::size_t a = first_a_ + i, b = first_b_ + k;
            a < shape_.sites_a && b < shape_.sites_b &&
            (shape_.coulomb(a, b) || shape_.short_range(a, b)))
          body(Pair{i, k, a, b});
  }
  template <class Body>
  POLHODE_INLINE void each_charged(const Body& body) const {
    each([&](Pair pair) POLHODE_INLINE_LAMBDA {
      if (shape_.coulomb(pair.a, pair.b)) body(pair);
    });
  }

  template <class Value>
  POLHODE_INLINE auto compute(const Value& value) const {  // Computes value(pair) for each pair.
    PerPair<decltype(value(Pair{}))> values;
    each([&](Pair pair) POLHODE_INLINE_LAMBDA { values[pair] = value(pair); });
    return values;
  }

 private:
  const Shape& shape_;
  std::size_t first_a_, first_b_;
};

/// The polynomial P that is subtracted from 1/r between charges, and −P'/r, for each pair. The
/// polynomial is computed by Horner's rule in y = 1 − r²/a². Each step of Horner's rule is done for
/// all pairs before the next step. The result is empty if no polynomial is used.
template <CutoffTreatment treatment, bool need_u, class Shape, class Real, class T>
POLHODE_INLINE inline auto smooth_parts(
    const SitePairs<Shape, Real>& pairs,
    const typename SitePairs<Shape, Real>::template PerPair<Real>& r2, const SmoothPart<T>& law) {
  using C = Constant<Real>;
  using Pairs = SitePairs<Shape, Real>;
  typename Pairs::template PerPair<PairValue<Real>> parts;
  if constexpr (is_smooth(treatment)) {
    typename Pairs::template PerPair<Real> y;
    typename Pairs::template PerPair<Polynomial<Real>> u, s;
    pairs.each_charged([&](auto pair) POLHODE_INLINE_LAMBDA {
      y[pair] = C(1) - r2[pair] * C(law.inverse_a2);
      u[pair] = Polynomial<Real>(C(law.u[law.degree + 1]));
      s[pair] = Polynomial<Real>(C(law.s[law.degree]));
    });
    for (std::size_t n = law.degree; n-- > 0;)
      pairs.each_charged([&](auto pair)
                             POLHODE_INLINE_LAMBDA { s[pair].step(y[pair], C(law.s[n])); });
    if constexpr (need_u)
      for (std::size_t n = law.degree + 1; n-- > 0;)
        pairs.each_charged([&](auto pair)
                               POLHODE_INLINE_LAMBDA { u[pair].step(y[pair], C(law.u[n])); });
    pairs.each_charged([&](auto pair) POLHODE_INLINE_LAMBDA {
      parts[pair] = {u[pair].value(y[pair]), s[pair].value(y[pair])};
    });
  }
  return parts;
}

/// The interaction of two charges, with charge = K q q. The energy divided by `charge` is 1/r −
/// P(r) up to the cutoff if a polynomial P is subtracted, and otherwise the truncated 1/r + k r² −
/// c.
template <CutoffTreatment treatment, class Real, class T>
POLHODE_INLINE inline PairValue<Real> coulomb_pair(
    Constant<Real> charge, const SiteTruncation<treatment, Real, T>& truncated,
    const PairLaws<T>& laws, const InversePowers<Real>& inverse_r, const Real& r2,
    const PairValue<Real>& smooth) {
  if constexpr (is_smooth(treatment)) {
    Real u = inverse_r.first() - smooth.u, s = inverse_r.third() - smooth.s;
    if constexpr (treatment == CutoffTreatment::smooth) {
      const auto within = r2 < Real(laws.cutoff_of_charges * laws.cutoff_of_charges);
      u = select(within, u, Real(0));
      s = select(within, s, Real(0));
    }
    return {charge * u, charge * s};
  } else {
    const PairValue<Real> unit = truncated(laws.reaction_field);
    return {charge * unit.u, charge * unit.s};
  }
}

/// Evaluates the potentials of a site pair. The function returns the sum of −u'/r of both
/// potentials, and adds the energies to their sums.
template <bool need_u, class Shape, class Real, class Coulomb, class ShortRange>
POLHODE_INLINE inline Real sum_of_laws(const Shape& shape, std::size_t a, std::size_t b,
                                       const Coulomb& coulomb, const ShortRange& short_range,
                                       PairLoad<Real>& load) {
  const auto add = [](const PairValue<Real>& value, Real& energy) POLHODE_INLINE_LAMBDA {
    if constexpr (need_u) energy += value.u;
    return value.s;
  };
  return !shape.short_range(a, b) ? add(coulomb(), load.coulomb)
         : !shape.coulomb(a, b)
             ? add(short_range(), load.van_der_waals)
             : add(coulomb(), load.coulomb) + add(short_range(), load.van_der_waals);
}

/// Adds the forces and energies of a group of pairs, as described at molecule_pair().
template <CutoffTreatment treatment, bool need_u, class Shape, class Real, class Law, class T,
          class SitesOfA, class SitesOfB>
POLHODE_INLINE inline void add_pairs(const SitePairs<Shape, Real>& pairs, const Shape& shape,
                                     const PairStrengths<Law>& strengths, const PairLaws<T>& laws,
                                     const Vec3<Real>& R, const SitesOfA& site_a,
                                     const SitesOfB& site_b, PairLoad<Real>& load) {
  typename SitePairs<Shape, Real>::template PerSite<Vec3<Real>> arm, f_b;
  pairs.each_b([&](auto k, std::size_t b)
                   POLHODE_INLINE_LAMBDA { arm[k] = site_b(b), f_b[k] = {}; });
  const auto r = pairs.compute(
      [&](auto pair) POLHODE_INLINE_LAMBDA { return R + arm[pair.k] - site_a(pair.a); });
  const auto r2 = pairs.compute([&](auto pair) POLHODE_INLINE_LAMBDA { return norm2(r[pair]); });
  const auto inverse_r =
      pairs.compute([&](auto pair) POLHODE_INLINE_LAMBDA { return InversePowers<Real>(r2[pair]); });
  const auto smooth = smooth_parts<treatment, need_u>(pairs, r2, laws.smooth);
  const auto s = pairs.compute([&](auto pair) POLHODE_INLINE_LAMBDA {
    const SiteTruncation<treatment, Real, T> truncated(laws, inverse_r[pair], r2[pair]);
    const std::size_t strength = pair.b * shape.sites_a + pair.a;
    return sum_of_laws<need_u>(
        shape, pair.a, pair.b,
        [&]() POLHODE_INLINE_LAMBDA {
          return coulomb_pair(Constant<Real>(strengths.charge[strength]), truncated, laws,
                              inverse_r[pair], r2[pair], smooth[pair]);
        },
        [&]() POLHODE_INLINE_LAMBDA { return truncated(strengths.law[strength]); }, load);
  });
  pairs.each([&](auto pair) POLHODE_INLINE_LAMBDA { add_scaled(f_b[pair.k], s[pair], r[pair]); });
  pairs.each_b([&](auto k, std::size_t) POLHODE_INLINE_LAMBDA {
    load.f += f_b[k];
    add_cross(load.tau_b, arm[k], f_b[k]);
  });
}

/// Sums over the site pairs of molecules a and b. The cutoff treatments are
///
/// - `molecule_switch`: U = w(R) Σ u(r), where R is the distance between the centres of mass,
/// - `site_switch`: U = Σ w(r) u(r),
/// - `site_shift`: U = Σ [u(r) − u(r_c) − (r − r_c) u'(r_c)] for r < r_c,
///
/// with u = u_short + K q q (1/r + k r² − c), where u_short is the short-range potential of the two
/// sites, and k and c describe the reaction field, and
///
/// - `smooth`: U = Σ w(r) u_short(r) + K q q (1/r − P(r)) for r < r_c, where P is the
///   SmoothPolynomial.
///
/// @tparam energies  whether energies are computed; the forces are the same either way
/// @param R       vector from the centre of a to the centre of b, with its periodic image [nm]
/// @param site_a  function that returns the position of site k of a relative to the centre of a,
///   lab frame [nm]
/// @param site_b  function that returns the position of site k of b relative to the centre of b,
///   lab frame [nm]
template <CutoffTreatment treatment, bool energies, class Shape, class Real, class Law, class T,
          class SitesOfA, class SitesOfB>
POLHODE_INLINE inline PairLoad<Real> molecule_pair(const Shape& shape,
                                                   const PairStrengths<Law>& strengths,
                                                   const PairLaws<T>& laws, const Vec3<Real>& R,
                                                   const SitesOfA& site_a, const SitesOfB& site_b) {
  constexpr bool by_molecule = treatment == CutoffTreatment::molecule_switch;
  PairLoad<Real> load;
  const auto add_group = [&](const SitePairs<Shape, Real>& pairs) POLHODE_INLINE_LAMBDA {
    add_pairs<treatment, energies || by_molecule>(pairs, shape, strengths, laws, R, site_a, site_b,
                                                  load);
  };
  if constexpr (by_molecule) {
    const MoleculeSwitch<Real, T> switched(laws.switching, R);
    SitePairs<Shape, Real>::each_group(shape, add_group);
    switched.apply_to(load);
  } else {
    SitePairs<Shape, Real>::each_group(shape, add_group);
  }
  return load;
}

}  // namespace polhode
