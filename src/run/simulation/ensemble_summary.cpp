// SPDX-License-Identifier: MIT
#include "polhode/run/simulation/ensemble_summary.hpp"

#include "polhode/base/units.hpp"
#include "polhode/model/centre_of_mass.hpp"

namespace polhode {
namespace {

/// Not a number without any.
double part(std::uint64_t some, std::uint64_t all) {
  return static_cast<double>(some) / static_cast<double>(all);
}

SeriesEstimate scaled(SeriesEstimate estimate, double factor) {
  estimate.value *= factor;
  estimate.error *= factor;
  return estimate;
}

}  // namespace

double BarostatSummary::acceptance() const { return part(accepted, moves); }
double HybridMonteCarloSummary::acceptance() const { return part(accepted, trajectories); }

EnsembleSummary ensemble_summary(const System& system, const EnsembleSettings& settings,
                                 const Trajectory& trajectory) {
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
        memory.barostat.work};
  if (settings.hybrid_monte_carlo)
    s.hybrid_monte_carlo = {
        memory.hybrid.trajectories, memory.hybrid.accepted,
        series_estimate(memory.hybrid.weights.means(), [](auto mean) { return mean[0]; }),
        memory.hybrid.work};
  return s;
}

}  // namespace polhode
