// SPDX-License-Identifier: MIT
#include "run/prepare/compressibility.hpp"

#include <algorithm>
#include <cmath>

#include "io/settings/ensemble_names.hpp"
#include "run/simulation/report/warning_rules.hpp"

namespace polhode {
namespace {

constexpr double max_relative_error = 0.5, min_relaxations = 8;
// While the compressibility is not known: its growth in a stage, and its maximum relative to the
// default.
constexpr double growth = 4, largest_growth = 16;
constexpr double min_change = 2;  // number of standard deviations of the volume

// Bounds on the compressibility relative to water (the default), from ice to a gas at a few bar.
constexpr double least = 0.1, most = 1000;

}  // namespace

SeriesEstimate measured_compressibility(const EnergyStatistics& energies,
                                        const BarostatSettings& barostat, double length,
                                        double kT) {
  SeriesEstimate e = energies.relative_volume_variance();
  e.value /= kT;
  e.error /= kT;
  if (e.known != Known::yes) return e;
  const Drift drift = energies.volume_drift();
  if (drift.known != Known::yes || drift.significant() || !(e.value > 0) ||
      e.error > max_relative_error * e.value ||
      length < min_relaxations * volume_relaxation(barostat, e.value))
    return {e.value, 0, Known::too_short};
  return e;
}

double next_compressibility(const EnergyStatistics& energies, const BarostatSettings& barostat,
                            double length, double kT) {
  const double scale = default_compressibility();
  if (const SeriesEstimate e = measured_compressibility(energies, barostat, length, kT);
      e.known == Known::yes)
    return std::clamp(e.value, least * scale, most * scale);
  const double present = barostat.compressibility;
  const double change = std::abs(energies.volume_drift().rate.value * length);
  const double fluctuation = std::sqrt(kT * present * energies.volume().value);
  if (!(change > min_change * fluctuation) || present >= largest_growth * scale) return present;
  return std::min(growth * present, largest_growth * scale);
}

}  // namespace polhode
