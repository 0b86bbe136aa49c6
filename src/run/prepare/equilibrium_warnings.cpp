// SPDX-License-Identifier: MIT
#include "equilibrium_warnings.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "io/settings/quantity.hpp"

namespace polhode {

std::optional<Warning> density_warning(const Drift& slope, double length, double volume) {
  constexpr double min_change = 0.005, significance_level = 0.001;
  const double change = slope.rate.value * length / volume;
  const bool known = slope.known == Known::yes;
  if ((known && slope.p_value > significance_level) || !(std::abs(change) >= min_change))
    return std::nullopt;
  return Warning{"density", change, min_change,
                 fmt::format("the volume is still {}: by {:.2g} % in the last {:g} ps{}",
                             change > 0 ? "growing" : "shrinking", 100 * std::abs(change), length,
                             known ? "" : ", a time too short for an error estimate"),
                 "prepare longer: npt = \"500 ps\" in [prepare], or give a density"};
}

std::optional<Warning> pressure_warning(const SeriesEstimate& pressure, const BarostatSettings& b) {
  constexpr double min_change = 0.005;
  const double bar = unit("bar", Dimension::pressure);
  const double bound = std::max(three_sigma(pressure), min_change / b.compressibility);
  if (pressure.known != Known::yes || std::abs(pressure.value - b.pressure) <= bound)
    return std::nullopt;
  return Warning{"barostat", pressure.value / bar, bound / bar,
                 fmt::format("the mean pressure is {:.3g} bar instead of {:g} bar: the volume has "
                             "not reached equilibrium",
                             pressure.value / bar, b.pressure / bar),
                 "prepare longer: npt = \"500 ps\" in [prepare], or give a density"};
}

}  // namespace polhode
