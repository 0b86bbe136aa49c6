// SPDX-License-Identifier: MIT
#include "run/simulation/system/stable_step.hpp"

#include <fmt/core.h>

#include <limits>

#include "integrate/stability.hpp"
#include "io/settings/output_units.hpp"
#include "polhode/model/degrees_of_freedom.hpp"
#include "run/simulation/system/einstein_frequency.hpp"
#include "run/simulation/system/relaxation.hpp"

namespace polhode {

double max_stable_step(const System& system, const State& state, const TrajectorySettings& settings,
                       Workers& workers) {
  if (settings.inner || degrees_of_freedom(system.topology).all() == 0)
    return std::numeric_limits<double>::infinity();
  return near_stability * stability_limit(settings.scheme) /
         einstein_frequency(system, state, workers);
}

std::optional<double> shorter_step(const System& system, const State& start,
                                   const TrajectorySettings& settings, Workers& workers) {
  if (molecules_overlap(system, start)) return std::nullopt;
  const double stable = max_stable_step(system, start, settings, workers);
  return stable < settings.step ? stable : settings.step / 2;
}

std::string rounded_fs(double step) {
  return fmt::format("{:g} fs", std::stod(fmt::format("{:.1e}", step * units::fs_per_ps)));
}

}  // namespace polhode
