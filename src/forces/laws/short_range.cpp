// SPDX-License-Identifier: MIT
#include "forces/laws/short_range.hpp"

#include <fmt/core.h>

#include <cmath>
#include <optional>

#include "polhode/base/error.hpp"

namespace polhode {
namespace {

/// Calls f with a null pointer to each law type of the list.
template <class F, class... Laws>
void each_law(const F& f, const std::variant<Laws...>*) {
  (f(static_cast<Laws*>(nullptr)), ...);
}
using List = ShortRange<double>::Law;

[[noreturn]] void refuse_to_mix(const Site& a, const Site& b) {
  throw Error(fmt::format(
      "sites '{}' and '{}' have the short-range potentials {} ({}) and {} ({}), for which there is "
      "no mixing rule; define this pair in a table [[pair]] of the run file",
      a.name, b.name, name(a.law), parameters(a.sigma, a.epsilon, a.law), name(b.law),
      parameters(b.sigma, b.epsilon, b.law)));
}

}  // namespace

ShortRange<double> short_range(double sigma, double epsilon, const ShortRangeLaw& law) {
  ShortRange<double> result;
  each_law(
      [&]<class Law>(Law*) {
        if (const auto* own = std::get_if<typename Law::Parameters>(&law))
          result = ShortRange<double>(Law::of(sigma, epsilon, *own));
      },
      static_cast<const List*>(nullptr));
  return result;
}

ShortRange<double> mix(const Site& a, const Site& b, MixingRule rule) {
  if (!a.has_short_range() || !b.has_short_range()) return {};
  const auto mean = [rule](double x, double y) {
    return rule == MixingRule::geometric ? std::sqrt(x * y) : (x + y) / 2;
  };
  std::optional<ShortRangeLaw> mixed;
  each_law(
      [&]<class Law>(Law*) {
        const auto* x = std::get_if<typename Law::Parameters>(&a.law);
        const auto* y = std::get_if<typename Law::Parameters>(&b.law);
        if (!x || !y) return;
        if (const auto both = Law::mixed(*x, *y, mean)) mixed = *both;
      },
      static_cast<const List*>(nullptr));
  if (!mixed) refuse_to_mix(a, b);
  return short_range(mean(a.sigma, b.sigma), std::sqrt(a.epsilon * b.epsilon), *mixed);
}

}  // namespace polhode
