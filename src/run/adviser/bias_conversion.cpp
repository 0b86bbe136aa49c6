// SPDX-License-Identifier: MIT
#include "run/adviser/bias_conversion.hpp"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <utility>

#include "io/files/with_error.hpp"
#include "io/settings/ensemble_text.hpp"
#include "io/settings/quantity.hpp"
#include "polhode/base/units.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/measure/block_means.hpp"
#include "polhode/run/simulation/trajectory/trajectory.hpp"

namespace polhode {
namespace {

constexpr double time_constant = 0.2;     // time constant of the thermostat [ps], with which U
                                          // relaxes
constexpr double sample_interval = 0.02;  // interval between samples [ps]
constexpr double discarded = 0.25;        // fraction of each run that is discarded

/// Sums over samples, relative to `first`: the potential energy U, the configurational pressure,
/// and the products U² and U times this pressure.
struct Fluctuations {
  Energies first;
  TimeBlocks blocks;

  void add(const Energies& now) {
    const double u = now.potential() - first.potential();
    const double p = of_positions(now) - of_positions(first);
    blocks.add(std::array{u, p, u * u, u * p});
  }

 private:
  static double of_positions(const Energies& e) {
    return e.pressure - 2 * e.translation / (3 * e.volume);
  }
};

Fluctuations fluctuations(System system, const Energies& first, double temperature,
                          const ResponseRuns& runs, const std::function<bool()>& stop) {
  Fluctuations found{first, {}};
  ForceField forces(system.topology, system.forces, system.state.box);
  TrajectorySettings settings{.scheme = scheme_of("hoa2-ends"),
                              .step = runs.step,
                              .length = runs.length,
                              .sample = sample_interval};
  settings.ensemble.temperature = temperature;
  settings.ensemble.thermostat = Rescaling{time_constant};
  const double begin = system.state.time + discarded * runs.length;
  run_trajectory(system, forces, settings,
                 {[&](std::size_t, const State& state, const Energies& now) {
                    if (state.time >= begin) found.add(now);
                  },
                  stop});
  return found;
}

Energies energies_of_start(System start) {
  ForceField forces(start.topology, start.forces, start.state.box);
  Load load;
  forces(start.state, load);
  return energies(start.state, start.bodies, load);
}

/// The error of a response. An error that cannot be estimated is taken to be as large as the
/// response.
double error_of(const SeriesEstimate& estimate) {
  return estimate.known == Known::yes ? estimate.error : std::abs(estimate.value);
}

}  // namespace

// In the canonical ensemble, cov(A, H) = kT² ∂⟨A⟩/∂T for the energy H and any quantity A, and
// cov(K, H) = kT ⟨K⟩ for the kinetic energy K. A function of positions is uncorrelated with the
// kinetic energy K, and the kinetic part of the pressure is proportional to T.
IsochoricResponse isochoric_response(const std::vector<System>& starts, double temperature,
                                     const ResponseRuns& runs, const std::function<bool()>& stop,
                                     Workers& workers) {
  const System& system = starts.front();
  const Energies first = energies_of_start(system);
  std::vector<Fluctuations> of_runs(starts.size());
  workers.each(starts.size(), [&](std::size_t k) {
    System start = starts[k];
    start.state.time = 0;
    of_runs[k] = fluctuations(std::move(start), first, temperature, runs, stop);
  });
  std::vector<BlockMeans::Block> all;
  for (const Fluctuations& run : of_runs)
    all.insert(all.end(), run.blocks.blocks.begin(), run.blocks.blocks.end());
  const DegreesOfFreedom n = degrees_of_freedom(system.topology);
  const double kT = units::boltzmann * temperature, kinetic = n.all() * kT / 2;
  const double ideal = n.translation / n.all() * 2 / (3 * system.state.box.volume());
  const BlockMeans blocks(std::move(all));
  return {series_estimate(
              blocks, [&](auto mean) { return (mean[2] - mean[0] * mean[0]) / (kT * kinetic); }),
          series_estimate(blocks, [&](auto mean) {
            return (mean[3] - mean[0] * mean[1]) / (kT * kinetic) + ideal;
          })};
}

BiasConversion::BiasConversion(const System& system, const EnsembleSettings& ensemble,
                               const IsochoricResponse& response)
    : fixed_(fixed_means(ensemble).value()),
      response_(response),
      molecules_(static_cast<double>(system.topology.size())),
      volume_(system.state.box.volume()) {
  const DegreesOfFreedom n = degrees_of_freedom(system.topology);
  kinetic_ = n.all() * units::boltzmann * ensemble.temperature / 2;
  translation_ = n.translation / n.all();
  if (!ensemble.barostat) return;
  pressure_ = ensemble.barostat->pressure;
  compressibility_ = ensemble.barostat->compressibility;
}

void BiasConversion::apply(Outcome& run) const {
  // At constant energy, a bias of the potential energy is balanced by the opposite bias of the
  // kinetic energy.
  const double missing = molecules_ * run.energy_bias;
  double pressure = run.pressure_bias + missing * response_.pressure.value;
  if (fixed_ == FixedMeans::kinetic_energy_and_pressure_of_positions)
    pressure -= 2 * (run.translation_bias + missing * translation_) / (3 * volume_);
  const double expansion = compressibility_ * volume_;  // expansion per pressure; 0 without a
                                                        // barostat
  // (∂U/∂V)_T = T (∂P/∂T)_V − P
  const double cohesion = kinetic_ * response_.pressure.value - pressure_;
  const double potential = missing * (1 + response_.energy.value) + expansion * pressure * cohesion;
  const double of_pressure = std::abs(missing) * error_of(response_.pressure);
  run.energy_bias = potential / molecules_;
  run.energy_bias_error =
      std::hypot(missing * error_of(response_.energy),
                 expansion * (std::abs(cohesion) * of_pressure +
                              std::abs(pressure) * kinetic_ * error_of(response_.pressure))) /
      molecules_;
  run.pressure_bias = pressure;
  run.pressure_bias_error = of_pressure;
}

bool needs_conversion(Quality quality, const EnsembleSettings& ensemble) {
  return !ensemble.constant_energy() &&
         (quality == Quality::energy_bias || quality == Quality::pressure_bias);
}

BiasConversion bias_conversion(const Config& config, const std::vector<ResumableRun>& starts,
                               const ResponseRuns& runs, const Callbacks& callbacks,
                               const std::function<bool()>& stop, Workers& workers) {
  EnsembleSettings ensemble = config.ensemble;
  ensemble.temperature = config.system.temperature;
  std::vector<System> systems;
  for (const ResumableRun& start : starts) systems.push_back(start.system);
  const IsochoricResponse response =
      isochoric_response(systems, ensemble.temperature, runs, stop, workers);
  const double bar = unit("bar", Dimension::pressure);
  callbacks.note(fmt::format(
      "note: biases at constant energy are converted to this ensemble: {}. Each kJ/mol of kinetic "
      "energy changes the potential energy by {} kJ/mol and the pressure by {} bar",
      description(ensemble), with_error(response.energy.value, error_of(response.energy)),
      with_error(response.pressure.value / bar, error_of(response.pressure) / bar)));
  return {systems.front(), ensemble, response};
}

}  // namespace polhode
