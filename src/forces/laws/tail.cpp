// SPDX-License-Identifier: MIT
#include "forces/laws/tail.hpp"

#include <cmath>

#include "forces/pairs/pair_table.hpp"
#include "polhode/base/units.hpp"

namespace polhode {
namespace {

// The integral ∫ (1 − w(r)) u r² dr from the start of the switch to infinity [kJ/mol nm³], by
// Simpson's rule inside the switch.
double tail_integral(const ForceSettings& s, const ShortRange<double>& law) {
  const Switch<> w(s.switch_from, s.cutoff, s.smoothness);
  constexpr int steps = 400;  // fourth-order rule: error below 1e-10 of the integral
  const double h = (s.cutoff - s.switch_from) / steps;
  double sum = 0;
  for (int k = 0; k <= steps; ++k) {
    const double r = s.switch_from + k * h, r2 = r * r;
    const double weight = k == 0 || k == steps ? 1 : k % 2 ? 4 : 2;
    sum += weight * (1 - w(r).w) * law(InversePowers<double>(r2), r2).u * r2;
  }
  return sum * h / 3 + law.integral_beyond(s.cutoff);
}

}  // namespace

double dispersion_tail(const Topology& topology, const ForceSettings& settings) {
  const PairTables tables(topology, settings.mixing);
  double sum = 0;
  for (std::size_t a = 0; a < topology.parts.size(); ++a)
    for (std::size_t b = 0; b < topology.parts.size(); ++b) {
      const double number = static_cast<double>(topology.parts[a].count) *
                            static_cast<double>(topology.parts[b].count);
      for (const ShortRange<double>& law : tables(a, b).any_law<double>().law)
        if (!law.is_zero()) sum += number * tail_integral(settings, law);
    }
  return 2 * units::pi * sum;
}

}  // namespace polhode
