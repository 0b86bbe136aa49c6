// SPDX-License-Identifier: MIT
#include "polhode/forces/laws/tail.hpp"

#include <cmath>

#include "polhode/base/units.hpp"
#include "polhode/forces/pairs/pair_table.hpp"

namespace polhode {
namespace {

// ∫ (1 − w(r)) r^(2−n) dr from the start of the switch to infinity, by Simpson's rule inside the
// switch.
double tail_integral(const ForceSettings& s, int n) {
  const Switch<> w(s.switch_from, s.cutoff, s.smoothness);
  constexpr int steps = 400;  // fourth-order rule: error below 1e-10 of the integral
  const double h = (s.cutoff - s.switch_from) / steps;
  double sum = 0;
  for (int k = 0; k <= steps; ++k) {
    const double r = s.switch_from + k * h;
    sum += (k == 0 || k == steps ? 1 : k % 2 ? 4 : 2) * (1 - w(r).w) * std::pow(r, 2 - n);
  }
  return sum * h / 3 + std::pow(s.cutoff, 3 - n) / (n - 3);
}

}  // namespace

double dispersion_tail(const Topology& topology, const ForceSettings& settings, const Box& box) {
  const PairTables tables(topology, settings.mixing);
  const double r6 = tail_integral(settings, 6), r12 = tail_integral(settings, 12);
  double sum = 0;
  for (std::size_t a = 0; a < topology.parts.size(); ++a)
    for (std::size_t b = 0; b < topology.parts.size(); ++b) {
      const PairStrengths<double>& pairs = tables(a, b).strengths<double>();
      const double number = static_cast<double>(topology.parts[a].count) *
                            static_cast<double>(topology.parts[b].count);
      for (std::size_t k = 0; k < pairs.c6.size(); ++k)
        sum += number * (pairs.c12[k] * r12 - pairs.c6[k] * r6);
    }
  return 2 * units::pi / box.volume() * sum;
}

}  // namespace polhode
