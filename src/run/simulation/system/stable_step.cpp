// SPDX-License-Identifier: MIT
#include "run/simulation/system/stable_step.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "integrate/stability.hpp"
#include "io/settings/output_units.hpp"
#include "polhode/base/units.hpp"
#include "polhode/model/degrees_of_freedom.hpp"
#include "run/simulation/system/relaxation.hpp"

namespace polhode {

double einstein_frequency(const System& system, const State& state, Workers& workers) {
  ForceField forces(system.topology, system.forces, state.box, workers);
  Load load(system.bodies.size());
  forces(state, load);
  double max_sum = 0;
  std::size_t body = 0;
  for (const auto& part : system.topology.parts) {
    std::array<double, 4> squares{};  // squares of p/√m and L_k/√J_k, and of their time derivatives
    for (std::size_t end = body + part.count; body < end; ++body) {
      const Bodies& b = system.bodies;
      squares[0] += dot(load.f[body], load.f[body]) * b.inverse_m[body] / 3;
      const Vec3<double> tau = to_body(state.orientation[body], load.tau[body]);
      for (std::size_t k = 0; k < 3; ++k) squares[k + 1] += tau[k] * tau[k] * b.inverse_J[body][k];
    }
    for (const double sum : squares)
      max_sum = std::max(max_sum, sum / static_cast<double>(part.count));
  }
  return std::sqrt(max_sum / (units::boltzmann * system.temperature));
}

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
