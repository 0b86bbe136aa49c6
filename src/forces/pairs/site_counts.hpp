// SPDX-License-Identifier: MIT
// The numbers of sites of two molecules, known at compile time or at run time.
#pragma once

#include <algorithm>

#include "base/unroll.hpp"
#include "forces/pairs/pair_table.hpp"
#include "math/dual.hpp"

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

}  // namespace polhode
