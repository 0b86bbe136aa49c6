// SPDX-License-Identifier: MIT
#include "forces/laws/tail.hpp"

#include <cmath>

#include "forces/pairs/pair_table.hpp"
#include "polhode/base/units.hpp"

namespace polhode {
namespace {

// Calls `point` at the points of Simpson's rule, with their weights.
template <class Point>
void simpson(double from, double to, int steps, const Point& point) {
  const double h = (to - from) / steps;
  for (int k = 0; k <= steps; ++k)
    point(from + k * h, (k == 0 || k == steps ? 1 : k % 2 ? 4 : 2) * h / 3);
}

// Calls `point` inside the switch, with weights that contain the removed part (1 − w(r)) u r².
template <class Point>
void removed_by_switch(const ForceSettings& s, const ShortRange<double>& law, const Point& point) {
  const Switch<> w(s.switch_from, s.cutoff, s.smoothness);
  constexpr int steps = 400;  // fourth-order rule: error below 1e-10 of the integral
  simpson(s.switch_from, s.cutoff, steps, [&](double r, double weight) {
    const double r2 = r * r;
    point(r, weight * (1 - w(r).w) * law(InversePowers<double>(r2), r2).u * r2);
  });
}

// The integral ∫ (1 − w(r)) u r² dr from the start of the switch to infinity [kJ/mol nm³].
double tail_integral(const ForceSettings& s, const ShortRange<double>& law) {
  double sum = 0;
  removed_by_switch(s, law, [&](double, double value) { sum += value; });
  return sum + law.integral_beyond(s.cutoff);
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

TailTransform::TailTransform(const ForceSettings& s, const ShortRange<double>& law) {
  // The integrand falls as r⁻⁴ and oscillates, so the part beyond the last point is below 1e-5.
  constexpr int steps = 2000;
  constexpr double farthest = 12;  // in cutoffs
  const auto add = [&](double r, double value) { r_.push_back(r), value_.push_back(value); };
  if (law.is_zero()) return;
  removed_by_switch(s, law, add);
  simpson(s.cutoff, farthest * s.cutoff, steps, [&](double r, double weight) {
    const double r2 = r * r;
    add(r, weight * law(InversePowers<double>(r2), r2).u * r2);
  });
}

TailTransform::Mode TailTransform::at(double k) const {
  Mode mode;
  for (std::size_t i = 0; i < r_.size(); ++i) {
    const double x = k * r_[i], sinc = std::sin(x) / x;
    mode.value += 4 * units::pi * value_[i] * sinc;
    mode.slope += 4 * units::pi * value_[i] * (std::cos(x) - sinc);
  }
  return mode;
}

}  // namespace polhode
