// SPDX-License-Identifier: MIT
#include "polhode/run/simulation/report/summary.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "io/settings/output_units.hpp"
#include "run/simulation/report/truncation_walk.hpp"

namespace polhode {
namespace {

/// The energy drift of the run, tested against the random walk of the conserved energy. The
/// strength of the random walk is taken from the shadow energy, if sampled, and is at least the
/// strength due to round-off. Without a shadow energy the strength of the random walk is unknown.
Drift drift_of(const TrajectoryStatistics& statistics, double rounding) {
  std::vector<WalkStrength> walks = statistics.shadow.walks();
  if (walks.empty()) return statistics.energies.drift_over_walk(rounding);
  for (WalkStrength& walk : walks) walk.rate = std::max(walk.rate, rounding);
  return statistics.energies.drift(walks);
}

/// Marks R as growing with the length of the run if random walks contribute more than 10 % of R².
/// @param rounding  variance per time of the random walk by round-off [(kJ/mol)²/ps]
void mark_growth(RunSummary& s, double rounding) {
  constexpr double max_share = 0.1;
  const double of_walk = std::hypot(
      s.ratio_of_walk(), walk_fluctuation(rounding, s.length) / s.potential_fluctuation.value);
  if (s.ratio.known != Known::yes || of_walk * of_walk <= max_share * std::pow(s.ratio.value, 2))
    return;
  s.ratio = {s.ratio.value, 0, Known::grows};
  s.total_fluctuation = {s.total_fluctuation.value, 0, Known::grows};
}

/// Adds means and fluctuations of energies, temperatures and pressure.
void add_averages(RunSummary& s, const TrajectoryStatistics& statistics) {
  const EnergyStatistics& energies = statistics.energies;
  const double per_molecule = 1 / static_cast<double>(s.molecules);
  s.samples = energies.samples;
  s.total = scaled(energies.total_with_error(), per_molecule);
  s.potential = scaled(energies.potential_with_error(), per_molecule);
  s.total_fluctuation = energies.total_fluctuation_with_error();
  s.potential_fluctuation = energies.potential_fluctuation_with_error();
  s.temperatures = energies.temperatures_with_errors(s.degrees_of_freedom);
  if (statistics.at_bath.samples > 0)
    s.temperatures_at_bath = statistics.at_bath.temperatures_with_errors(s.degrees_of_freedom);
  s.pressure = energies.pressure();
  s.ratio = energies.ratio_with_error();
}

/// Removes the results on energy conservation, which do not apply to hybrid Monte Carlo. In hybrid
/// Monte Carlo, new momenta and acceptance decisions change the energy. The energy errors of the
/// trajectories of hybrid Monte Carlo add up to a random walk that causes no bias.
void remove_conservation(RunSummary& s) {
  constexpr SeriesEstimate none{.value = std::numeric_limits<double>::quiet_NaN(),
                                .known = Known::not_defined};
  s.ratio = s.total_fluctuation = none;
  s.drift = {{none.value, 0}, 1, Known::not_defined};
  s.walk = 0;
  s.rounding = s.truncation = none.value;
}

}  // namespace

double RunSummary::relative_drift() const {
  const double V = potential_fluctuation.value;
  return V > 0 ? std::abs(drift.rate.value) * length / V : 0;
}

double RunSummary::ratio_of_walk() const {
  const double V = potential_fluctuation.value;
  return V > 0 ? walk_fluctuation(walk, length) / V : 0;
}

RunSummary summary(const System& system, const TrajectorySettings& settings,
                   const Trajectory& trajectory, const ForceNoise& noise) {
  RunSummary s;
  s.molecules = system.topology.size();
  s.segment = trajectory.segment;
  s.steps = trajectory.steps - s.segment.first_step;
  s.length = static_cast<double>(s.steps) * settings.step;
  s.sample = static_cast<double>(settings.steps_per_sample()) * settings.step;
  s.degrees_of_freedom = degrees_of_freedom(system.topology);

  const NestedScheme scheme{settings.scheme, settings.inner};
  const EnergyStatistics& energies = trajectory.statistics.energies;
  add_averages(s, trajectory.statistics);
  s.potential_drift = energies.potential_drift();
  s.equilibrium_start = energies.samples_before_equilibrium() * s.sample;
  s.configurational = trajectory.statistics.configurational.temperatures();
  s.momentum = norm(total_momentum(system.state));

  const double rounding = rounding_walk(noise, scheme, settings.lambda, settings.step) +
                          double_walk(energies.first, settings.step);
  s.walk_known = system.forces.precision == Precision::double_precision || noise.power > 0;
  s.drift = drift_of(trajectory.statistics, rounding);
  if (std::abs(s.drift.rate.value) <= double_drift(energies.first, settings.step))
    s.drift.p_value = 1;  // the drift is not larger than round-off
  s.shadow = shadow_summary(trajectory.statistics.shadow, s.drift);
  s.walk = std::max(s.drift.walk, s.shadow ? s.shadow->drift.walk : 0.0);
  mark_growth(s, rounding);
  const std::optional<FixedMeans> fixed = settings.fixed_means();
  if (fixed && s.potential_fluctuation.value > 0 &&
      trajectory.statistics.step_bias.response.samples() >= min_samples_reported) {
    s.step_bias = trajectory.statistics.step_bias.bias(
        s.degrees_of_freedom, *fixed, settings.ensemble.temperature, system.topology.mass());
    s.configurational_bias =
        trajectory.statistics.configurational.step_bias(s.degrees_of_freedom.all(), *fixed);
  }
  if (s.potential_fluctuation.value > 0)
    s.rounding = rounding_fluctuation(noise, scheme, settings.lambda, settings.step, s.length) /
                 s.potential_fluctuation.value;
  if (s.potential_fluctuation.value > 0)
    s.truncation =
        walk_fluctuation(truncation_walk(system.topology, system.forces, energies.first.volume,
                                         s.temperatures.all.value, scheme.outer, settings.step),
                         s.length) /
        s.potential_fluctuation.value;
  if (settings.ensemble.hybrid_monte_carlo) remove_conservation(s);
  s.ensemble = ensemble_summary(system, settings, trajectory);
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
