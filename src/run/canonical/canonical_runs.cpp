// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <limits>

#include "io/files/write_file.hpp"
#include "measure/autocorrelation_time.hpp"
#include "polhode/base/units.hpp"
#include "polhode/forces/force_field.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/io/files/table_file.hpp"
#include "polhode/math/random.hpp"
#include "polhode/measure/radial_distribution.hpp"
#include "polhode/run/canonical/canonical_study.hpp"
#include "polhode/run/simulation/trajectory/trajectory.hpp"
#include "polhode/run/study/study.hpp"
#include "run/study/study_tasks.hpp"

namespace polhode {
namespace {

constexpr double sample_interval = 0.02, default_configurational_interval = 0.05,
                 radial_interval = 0.1;  // interval between samples of g(r) [ps]
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// The settings of a run of a method, without its length and seed.
TrajectorySettings settings_of(const CanonicalMethod& method, const Config& config) {
  const double configurational = config.study.configurational_sample;
  TrajectorySettings settings{.scheme = method.scheme,
                              .step = method.step,
                              .sample = sample_interval,
                              .lambda = config.integrator.lambda};
  settings.configurational_sample =
      configurational > 0 ? configurational : default_configurational_interval;
  settings.ensemble.temperature = config.system.temperature;
  if (method.hybrid)
    settings.ensemble.hybrid_monte_carlo =
        config.ensemble.hybrid_monte_carlo.value_or(HybridMonteCarloSettings{});
  else
    settings.ensemble.thermostat = config.ensemble.thermostat.value_or(ThermostatSettings{});
  return settings;
}

/// The seed of a run. Each combination of method and initial configuration has separate random
/// numbers, so that the errors of two points are independent.
std::uint64_t seed_of(const CanonicalMethod& method, std::uint64_t start) {
  const std::string hash = text_hash(fmt::format("{} {:.12g}", method.text, method.step));
  std::uint64_t index = 0;
  std::from_chars(hash.data(), hash.data() + hash.size(), index, 16);
  return derived_seed(start, index);
}

/// The first peak of g(r) of the first pair of sites.
class FirstPeak {
 public:
  explicit FirstPeak(const System& system)
      : g_(system.topology, {.pairs = {site_pairs(system.topology).front()},
                             .cutoff = std::min(1.0, 0.499 * system.state.box.shortest_edge()),
                             .bin = 0.004}) {}

  void sample(const State& state) {
    if (state.time < next_) return;
    next_ = state.time + radial_interval * (1 - 1e-9);
    g_.add(state);
  }

  double height() const {
    const auto peak = g_.first_peak(0);
    return peak ? peak->height.value : unknown;
  }

 private:
  RadialDistribution g_;
  double next_ = -std::numeric_limits<double>::infinity();
};

/// The configurational temperatures of translation, and of rotation about all axes together [K].
std::array<double, 2> configurational(const ConfigurationalStatistics& statistics) {
  const std::vector<double> mean = statistics.blocks.means().mean();
  if (mean.empty()) return {unknown, unknown};
  const auto kelvin = [](double square, double curvature) {
    return curvature != 0 ? square / (units::boltzmann * curvature) : unknown;
  };
  return {kelvin(mean[0], mean[4]),
          kelvin(mean[1] + mean[2] + mean[3], mean[5] + mean[6] + mean[7])};
}

/// The mean rotational temperature over all axes with a moment of inertia, weighted by degrees of
/// freedom [K].
double rotation(const Temperatures& T, const DegreesOfFreedom& n) {
  double sum = 0, all = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += n.rotation[k] * T.rotation[k], all += n.rotation[k];
  return all > 0 ? sum / all : unknown;
}

void add_results(CanonicalRun& run, const Trajectory& t, const System& system) {
  const EnergyStatistics& energies = t.statistics.energies;
  const DegreesOfFreedom n = degrees_of_freedom(system.topology);
  const Temperatures T = energies.temperatures(n);
  const auto [translation, rotational] = configurational(t.statistics.configurational);
  run.means[0] = energies.potential() / static_cast<double>(system.topology.size());
  run.means[1] = translation;
  run.means[2] = rotational;
  run.means[3] = n.translation > 0 ? T.translation : unknown;
  run.means[4] = rotation(T, n);
  const HybridMonteCarloMemory& hybrid = t.ensemble.hybrid;
  if (hybrid.trajectories == 0) return;
  run.acceptance = static_cast<double>(hybrid.accepted) / static_cast<double>(hybrid.trajectories);
  run.weight = hybrid.weights.means().mean().at(0);
}

CanonicalRun one_run(const System& start, std::size_t index, const CanonicalMethod& method,
                     const Config& config, const std::function<bool()>& stop) {
  CanonicalRun run{.scheme = method.text, .step = method.step, .start = static_cast<int>(index)};
  System system = start;
  ForceField forces(system.topology, system.forces, system.state.box);
  TrajectorySettings settings = settings_of(method, config);
  settings.seed = seed_of(method, start_seed(config, index));
  settings.length = relaxation(config.study.length);
  run.stable = run_trajectory(system, forces, settings, {nullptr, stop}).failure.empty();
  if (!run.stable) return run;

  settings.seed = derived_seed(settings.seed, 1);
  settings.length = config.study.length - settings.length;
  std::vector<double> potential;
  FirstPeak peak(system);
  const Trajectory t = run_trajectory(system, forces, settings,
                                      {[&](std::size_t, const State& state, const Energies& now) {
                                         potential.push_back(now.potential());
                                         peak.sample(state);
                                       },
                                       stop});
  run.stable = t.failure.empty();
  if (!run.stable) return run;
  add_results(run, t, system);
  run.means[5] = peak.height();
  const auto tau = autocorrelation_time(potential);
  run.correlation_time =
      tau ? tau->value * static_cast<double>(settings.steps_per_sample()) * settings.step : unknown;
  return run;
}

/// Prepares an initial configuration of the canonical ensemble: an equilibration, followed by
/// hybrid Monte Carlo of the same length.
System canonical_start(const System& base, const Config& config, std::size_t index, double step,
                       const std::function<bool()>& stop) {
  const double length = config.study.decorrelate;
  System start = prepare_start(base, config, index, length, stop);
  if (stop && stop()) return start;
  ForceField forces(start.topology, start.forces, start.state.box);
  const CanonicalMethod draw{"", "", scheme_of("hoa2"), true, step};
  TrajectorySettings settings = settings_of(draw, config);
  settings.configurational_sample = 0;
  settings.length = std::max(length, step);
  settings.seed = start_seed(config, index);
  run_trajectory(start, forces, settings, {nullptr, stop});
  start.state.time = 0;
  return start;
}

}  // namespace

void perform_canonical_runs(const Config& config, const std::vector<CanonicalRun>& known,
                            const std::function<void(const CanonicalRun&)>& finished,
                            const Callbacks& callbacks, Workers& workers) {
  const StudySettings& study = config.study;
  const std::vector<CanonicalMethod> methods = canonical_methods(study);
  double shortest = std::numeric_limits<double>::infinity();  // smallest step [ps]
  for (const CanonicalMethod& method : methods) shortest = std::min(shortest, method.step);
  // All methods are run from one initial configuration before the runs from the next configuration
  // begin. The points of an interrupted study therefore have equal numbers of runs.
  StudyTasks<CanonicalMethod> tasks(callbacks, workers);
  for (int start = 0; start < study.runs; ++start)
    for (const CanonicalMethod& method : methods)
      tasks.add(method, method.text, start, method.cost() * study.length, known);
  if (tasks.empty()) return;
  const System base = build_system(config);
  tasks.prepare(base, study.runs, 0, [&](std::size_t start) {
    return canonical_start(base, config, start, shortest, callbacks.stop);
  });
  tasks.perform(finished,
                [&](const CanonicalMethod& method, const System& start, std::size_t index) {
                  return one_run(start, index, method, config, callbacks.stop);
                });
}

}  // namespace polhode
