// SPDX-License-Identifier: MIT
#include "polhode/run/simulation/report/ensemble_summary.hpp"

#include "polhode/base/units.hpp"
#include "polhode/model/centre_of_mass.hpp"

namespace polhode {
namespace {

/// The fraction `some`/`all`; NaN if `all` is 0.
double part(std::uint64_t some, std::uint64_t all) {
  return static_cast<double>(some) / static_cast<double>(all);
}

/// The mean of a quantity over a series of moves or trajectories.
SeriesEstimate mean_of(const TimeBlocks& blocks, std::size_t quantity) {
  return series_estimate(blocks.means(), [quantity](auto mean) { return mean[quantity]; });
}

/// The effective number of samples n/2τ, with the relative error of τ.
SeriesEstimate effective_samples(const SeriesEstimate& correlation_time, double samples) {
  SeriesEstimate n = correlation_time;
  n.value = samples / (2 * correlation_time.value);
  n.error = n.value * correlation_time.error / correlation_time.value;
  return n;
}

}  // namespace

double BarostatSummary::acceptance() const { return part(accepted, moves); }
double HybridMonteCarloSummary::acceptance() const { return part(accepted, trajectories); }

EnsembleSummary ensemble_summary(const System& system, const TrajectorySettings& of,
                                 const Trajectory& trajectory) {
  const EnsembleSettings& settings = of.ensemble;
  const EnsembleMemory& memory = trajectory.ensemble;
  const EnergyStatistics& energies = trajectory.statistics.energies;
  EnsembleSummary s{settings, memory.heat, {}, {}};
  if (settings.barostat)
    s.barostat = {
        scaled(energies.inverse_volume(), total_mass(system.bodies)),
        energies.volume(),
        scaled(energies.relative_volume_variance(), 1 / (units::boltzmann * settings.temperature)),
        energies.volume_drift(),
        memory.barostat.moves,
        memory.barostat.accepted,
        memory.barostat.evaluations,
        memory.barostat.work,
        mean_of(memory.barostat.decisions, 0),
        of.move_interval(),
        memory.barostat.beyond_shape};
  if (settings.hybrid_monte_carlo) {
    const SeriesEstimate tau = energies.correlation_time_of_potential();
    const double sample = static_cast<double>(of.steps_per_sample()) * of.step;
    s.hybrid_monte_carlo = {memory.hybrid.trajectories,
                            memory.hybrid.accepted,
                            mean_of(memory.hybrid.weights, 0),
                            memory.hybrid.work,
                            mean_of(memory.hybrid.weights, 1),
                            scaled(tau, sample),
                            effective_samples(tau, static_cast<double>(energies.samples)),
                            mean_of(memory.hybrid.weights, 2)};
  }
  return s;
}

}  // namespace polhode
