// SPDX-License-Identifier: MIT
#include "polhode/run/simulation/stable_step.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>

#include "polhode/integrate/stability.hpp"
#include "polhode/io/output_units.hpp"
#include "polhode/model/degrees_of_freedom.hpp"
#include "polhode/run/simulation/einstein_frequency.hpp"

namespace polhode {

double max_stable_step(const System& system, const State& state, const TrajectorySettings& settings,
                       Workers& workers) {
  if (settings.inner || degrees_of_freedom(system.topology).all() == 0)
    return std::numeric_limits<double>::infinity();
  return near_stability * stability_limit(settings.scheme) /
         einstein_frequency(system, state, workers);
}

double shorter_step(const System& system, const State& start, const TrajectorySettings& settings,
                    Workers& workers) {
  const double stable = max_stable_step(system, start, settings, workers);
  return std::max(settings.step / 10, std::min(settings.step / 2, stable));
}

std::string rounded_fs(double step) {
  return fmt::format("{:g} fs", std::stod(fmt::format("{:.1e}", step * units::fs_per_ps)));
}

}  // namespace polhode
