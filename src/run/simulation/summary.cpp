// SPDX-License-Identifier: MIT
#include "polhode/run/simulation/summary.hpp"
#include "polhode/io/output_units.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace polhode {
namespace {

/// The random walk of the energy: that of the shadow energy, where it was sampled, and no less than
/// rounding makes it.
std::vector<WalkStrength> walks(const ShadowStatistics& shadow, double rounding) {
  std::vector<WalkStrength> result = shadow.walks();
  if (result.empty()) return {{1, rounding}};
  for (WalkStrength& walk : result) walk.rate = std::max(walk.rate, rounding);
  return result;
}

}  // namespace

RunSummary summary(const System& system, const TrajectorySettings& settings,
                   const Trajectory& trajectory, const ForceNoise& noise) {
  RunSummary s;
  s.molecules = system.topology.size();
  s.steps = trajectory.steps;
  s.length = static_cast<double>(trajectory.steps) * settings.step;
  s.sample = static_cast<double>(settings.steps_per_sample()) * settings.step;
  s.degrees_of_freedom = degrees_of_freedom(system.topology);

  const NestedScheme scheme{settings.scheme, settings.inner};
  const EnergyStatistics& energies = trajectory.statistics.energies;
  s.samples = energies.samples;
  s.total = energies.total() / static_cast<double>(s.molecules);
  s.potential = energies.potential() / static_cast<double>(s.molecules);
  s.total_fluctuation = energies.total_fluctuation();
  s.potential_fluctuation = energies.potential_fluctuation();
  s.temperatures = energies.temperatures(s.degrees_of_freedom);
  s.temperature = energies.temperature(s.degrees_of_freedom);
  if (const EnergyStatistics& at_bath = trajectory.statistics.at_bath; at_bath.samples > 0) {
    s.temperatures_at_bath = at_bath.temperatures(s.degrees_of_freedom);
    s.temperature_at_bath = at_bath.temperature(s.degrees_of_freedom);
  }
  s.potential_drift = energies.potential_drift();
  s.pressure = energies.pressure();
  s.ratio = energies.ratio_with_error();
  s.configurational = trajectory.statistics.configurational.temperatures();
  s.momentum = norm(total_momentum(system.state));

  const double rounding = rounding_walk(noise, scheme, settings.lambda, settings.step) +
                          double_walk(energies.first, settings.step);
  s.walk_known = system.forces.precision == Precision::double_precision || noise.power > 0;
  s.drift = energies.drift(walks(trajectory.statistics.shadow, rounding));
  if (std::abs(s.drift.rate.value) <= double_drift(energies.first, settings.step))
    s.drift.p_value = 1;  // no larger than rounding
  s.shadow = shadow_summary(trajectory.statistics.shadow, s.drift);
  const std::optional<FixedMeans> fixed = settings.fixed_means();
  if (fixed && s.potential_fluctuation > 0 &&
      trajectory.statistics.step_bias.response.samples() >= min_samples_reported) {
    s.step_bias = trajectory.statistics.step_bias.bias(s.degrees_of_freedom, *fixed,
                                                       settings.ensemble.temperature);
    s.configurational_bias =
        trajectory.statistics.configurational.step_bias(s.degrees_of_freedom.all(), *fixed);
  }
  if (s.potential_fluctuation > 0)
    s.rounding = rounding_fluctuation(noise, scheme, settings.lambda, settings.step, s.length) /
                 s.potential_fluctuation;
  s.ensemble = ensemble_summary(system, settings.ensemble, trajectory);
  s.force_evaluations = trajectory.force_evaluations;
  s.derivatives = trajectory.derivatives;
  s.near_evaluations = trajectory.near_evaluations;
  s.near_derivatives = trajectory.near_derivatives;
  s.measurements = trajectory.measurements;
  s.list_rebuilds = trajectory.list_rebuilds;
  s.timings = trajectory.timings;
  const double seconds = trajectory.timings.all();
  s.ns_per_day = seconds > 0 ? s.length / units::ps_per_ns / seconds * units::seconds_per_day : 0;
  return s;
}

}  // namespace polhode
