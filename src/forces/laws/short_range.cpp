// SPDX-License-Identifier: MIT
#include "polhode/forces/laws/short_range.hpp"

#include <fmt/core.h>

#include <cmath>

#include "polhode/base/error.hpp"

namespace polhode {
namespace {

double mean_of(double a, double b, MixingRule rule) {
  return rule == MixingRule::geometric ? std::sqrt(a * b) : (a + b) / 2;
}

// One overload for each law: the law of two sites whose own laws are of that kind.
struct Mixed {
  const Site &a, &b;
  MixingRule rule;
  double sigma = mean_of(a.sigma, b.sigma, rule), epsilon = std::sqrt(a.epsilon * b.epsilon);

  ShortRange<double> operator()(const LennardJonesLaw&, const LennardJonesLaw&) const {
    return short_range(sigma, epsilon, LennardJonesLaw{});
  }
  ShortRange<double> operator()(const MieLaw& x, const MieLaw& y) const {
    return short_range(sigma, epsilon, MieLaw{mean_of(x.n, y.n, rule), mean_of(x.m, y.m, rule)});
  }
  ShortRange<double> operator()(const BuckinghamLaw& x, const BuckinghamLaw& y) const {
    return short_range(
        0, 0, BuckinghamLaw{std::sqrt(x.A * y.A), 2 / (1 / x.B + 1 / y.B), std::sqrt(x.C * y.C)});
  }
  ShortRange<double> operator()(const TabulatedLaw& x, const TabulatedLaw& y) const {
    if (x != y) refuse();
    return short_range(0, 0, x);
  }
  template <class X, class Y>
  ShortRange<double> operator()(const X&, const Y&) const {
    refuse();
  }

  [[noreturn]] void refuse() const {
    throw Error(fmt::format(
        "sites '{}' and '{}' have the laws {} ({}) and {} ({}), which no rule mixes; give the pair "
        "in a table [[pair]] of the run file",
        a.name, b.name, name(a.law), parameters(a.sigma, a.epsilon, a.law), name(b.law),
        parameters(b.sigma, b.epsilon, b.law)));
  }
};

}  // namespace

ShortRange<double> short_range(double sigma, double epsilon, const ShortRangeLaw& law) {
  if (const auto* mie = std::get_if<MieLaw>(&law))
    return ShortRange<double>(Mie<>::of(sigma, epsilon, *mie));
  if (const auto* buckingham = std::get_if<BuckinghamLaw>(&law))
    return ShortRange<double>(Buckingham<>::of(*buckingham));
  if (const auto* tabulated = std::get_if<TabulatedLaw>(&law))
    return ShortRange<double>(Tabulated<>::of(*tabulated));
  return ShortRange<double>(LennardJones<>::of(sigma, epsilon));
}

ShortRange<double> mix(const Site& a, const Site& b, MixingRule rule) {
  if (!a.has_short_range() || !b.has_short_range()) return {};
  return std::visit(Mixed{a, b, rule}, a.law, b.law);
}

}  // namespace polhode
