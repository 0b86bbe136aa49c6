// SPDX-License-Identifier: MIT
#include "polhode/run/summary.hpp"

#include <vector>

namespace polhode {

RunSummary summary(const System& system, const TrajectorySettings& settings,
                   const Trajectory& trajectory, const ForceNoise& noise) {
  RunSummary s;
  s.molecules = system.topology.size();
  s.steps = trajectory.steps;
  s.length = static_cast<double>(trajectory.steps) * settings.step;
  s.sample = static_cast<double>(settings.steps_per_sample()) * settings.step;
  s.freedoms = freedoms(system.topology);

  std::vector<double> total, potential;
  for (const Energies& e : trajectory.samples) {
    total.push_back(e.total());
    potential.push_back(e.potential());
  }
  s.total = mean(total).value / static_cast<double>(s.molecules);
  s.potential = mean(potential).value / static_cast<double>(s.molecules);
  s.temperatures = mean_temperatures(trajectory.samples, s.freedoms);
  s.configurational = configurational_temperatures(trajectory.configurational);
  std::vector<double> pressures;
  for (const Energies& e : trajectory.samples) pressures.push_back(e.pressure);
  s.pressure = block_mean(pressures);
  s.momentum = norm(total_momentum(system.state));

  if (trajectory.samples.size() > 2) {
    s.total_fluctuation = fluctuation(total);
    s.potential_fluctuation = fluctuation(potential);
    s.ratio = fluctuation_ratio_with_error(trajectory.samples);
    s.drift = drift(trajectory.samples);
    s.shadow = shadow_summary(trajectory.brackets, settings.scheme, settings.step, s.drift);
    if (s.potential_fluctuation > 0)
      s.rounding = rounding_fluctuation(noise, {settings.scheme, settings.inner}, settings.lambda,
                                        settings.step, s.length) /
                   s.potential_fluctuation;
  }
  s.force_evaluations = trajectory.force_evaluations;
  s.derivatives = trajectory.derivatives;
  s.near_evaluations = trajectory.near_evaluations;
  s.near_derivatives = trajectory.near_derivatives;
  s.measurements = trajectory.measurements;
  s.list_rebuilds = trajectory.list_rebuilds;
  s.timings = trajectory.timings;
  const double seconds = trajectory.timings.all();
  s.ns_per_day = seconds > 0 ? s.length / 1000 / seconds * 86400 : 0;
  return s;
}

}  // namespace polhode
