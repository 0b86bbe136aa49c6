// SPDX-License-Identifier: MIT
#include "run/properties/replica.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "io/settings/ensemble_names.hpp"
#include "measure/dielectric.hpp"
#include "measure/displacement.hpp"
#include "measure/reorientation.hpp"
#include "polhode/base/units.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/math/random.hpp"
#include "polhode/run/prepare/preparation.hpp"
#include "polhode/run/simulation/report/summary.hpp"
#include "polhode/run/simulation/system/system.hpp"
#include "polhode/run/simulation/trajectory/trajectory.hpp"
#include "run/prepare/compressibility.hpp"
#include "run/properties/chain.hpp"
#include "run/properties/distances.hpp"
#include "run/properties/low_frequency_spectrum.hpp"
#include "run/properties/phases.hpp"
#include "run/simulation/system/relaxation.hpp"
#include "run/simulation/system/stable_step.hpp"

namespace polhode {
namespace {

constexpr double first_step = 0.001;  // first step of the preparation [ps]
constexpr double tenth_of_fs = 1e-4;  // 0.1 fs [ps]
constexpr double max_ratio = 0.015;   // maximum R of the segments

double rounded(double step) {
  return std::max(tenth_of_fs, std::floor(step / tenth_of_fs + 1e-9) * tenth_of_fs);
}

/// A stage of the preparation.
struct Stage {
  std::size_t steps;
  double heat = 1;  ///< temperature relative to the temperature of the state point
  bool has_barostat = false;
};
/// The second stage melts the lattice. Near the melting point, a crystal would survive the other
/// stages.
constexpr std::array stages = {Stage{500},           Stage{2500, 2.5},     Stage{2500},
                               Stage{2500, 1, true}, Stage{2500, 1, true}, Stage{5000, 1, true}};

TrajectorySettings settings_of(const Chain& chain, const Replica& replica, const Stage& stage,
                               std::uint64_t stream, double step) {
  TrajectorySettings t =
      chain.trajectory(scheme_of("baoab"), step, step * static_cast<double>(stage.steps), stream);
  t.ensemble.temperature *= stage.heat;
  t.ensemble.thermostat = Langevin{0.01 / step, 0.01 / step};
  if (stage.has_barostat && !chain.settings().at.constant_volume())
    t.ensemble.barostat = barostat(chain.settings(), replica.compressibility, step);
  return t;
}

/// Runs a stage of the preparation. A stage that blows up begins again at half of the step, because
/// the forces on a lattice do not tell how hard molecules collide later.
/// @return  the trajectory; empty if it was stopped
std::optional<Trajectory> run_stage(Chain& chain, const Replica& replica, const Stage& stage,
                                    std::uint64_t stream, double& step, LongestWaves& waves) {
  constexpr int repetitions = 3;
  const State start = chain.system().state;
  const Watch watch{
      .sample = [&](std::size_t, const State& state, const Energies&) { waves.add(state); }};
  for (int k = 0; k < repetitions; ++k) {
    Trajectory done = chain.attempt(settings_of(chain, replica, stage, stream, step), watch);
    if (done.stopped) return std::nullopt;
    if (done.failure.empty()) return done;
    chain.system().state = start;
    step = rounded(step / 2);
    waves = {};
  }
  return chain.run(settings_of(chain, replica, stage, stream, step), watch);
}

/// The density at which a replica of constant volume is melted. For a lattice it is not below the
/// density of the liquid, because the forces of a dilute lattice give no information about
/// collisions.
double first_density(const ReplicaSettings& settings) {
  const bool is_lattice = settings.config.system.initial_configuration.empty();
  return is_lattice ? std::max(settings.at.density, settings.liquid_density) : settings.at.density;
}

/// Relaxes a replica at constant volume, and then at constant pressure with adaptive barostat
/// moves, unless the state point has constant volume.
bool relax(Chain& chain, Replica& replica) {
  System& system = chain.system();
  const ReplicaSettings& settings = chain.settings();
  const bool constant_volume = settings.at.constant_volume();
  if (constant_volume) scale_to(system.state, system.topology.mass() / first_density(settings));
  check_separated(system, minimise(system, relaxed_start));
  draw_momenta(system, derived_seed(settings.config.system.seed, replica.index));
  const double kT = units::boltzmann * settings.at.temperature;
  double step = first_step;
  std::uint64_t stream = preparing;
  const double first_compressibility = replica.compressibility;
  bool is_known = false;
  for (const Stage& stage : stages) {
    if (stage.has_barostat && constant_volume)
      scale_to(system.state, system.topology.mass() / settings.at.density);
    LongestWaves waves;
    const auto done = run_stage(chain, replica, stage, stream++, step, waves);
    if (!done) return false;
    const TrajectorySettings t = settings_of(chain, replica, stage, stream, step);
    if (t.ensemble.barostat) {
      const EnergyStatistics& energies = done->statistics.energies;
      const BarostatSettings& b = *t.ensemble.barostat;
      is_known = measured_compressibility(energies, b, t.length, kT).known == Known::yes;
      replica.compressibility = next_compressibility(energies, b, t.length, kT);
    }
    check_liquid(system.state, system.topology.mass(), settings);
    // A lattice below the density of the liquid is inhomogeneous while it condenses.
    if (&stage == &stages.back()) check_one_phase(waves, system.state.size(), settings.at);
    // In a dilute gas the forces give no information about collisions, so the step does not grow
    // any more.
    const double stable = rounded(max_stable_step(system, system.state, t) / 4);
    step = stream == preparing + 1 ? stable : std::min(step, stable);
  }
  // A large guess makes the volume relax quickly. With it, volume moves of longer steps would
  // overshoot.
  if (!is_known) replica.compressibility = first_compressibility;
  return true;
}

/// Calls a function with the list of the segments of a kind of run.
template <class AnyReplica, class F>
auto with_segments(AnyReplica& replica, MeasuredIn kind, const F& f) {
  if (auto* const chain = chain_of(replica, kind)) return f(chain->segments);
  if (kind == MeasuredIn::coupling) return f(replica.coupled.segments);
  if (kind == MeasuredIn::slab) return f(replica.slab.segments);
  return f(replica.averages);
}

/// How far a run of averages at some step is beyond the bounds of R and of the predicted bias of
/// the potential energy. Hybrid Monte Carlo has no bias, but it must accept most trajectories:
/// energies at their ends differ by √2 rms deviations, and an rms difference of 1 kT is accepted in
/// 62 %.
double beyond_bounds(const RunSummary& s, const Trajectory& done, const ReplicaSettings& settings) {
  const double ratio = s.ratio.value / max_ratio;
  if (settings.sampling == Sampling::hybrid_monte_carlo)
    return std::max(ratio, std::numbers::sqrt2 * s.total_fluctuation.value /
                               (units::boltzmann * settings.at.temperature));
  if (!s.step_bias) return ratio;
  const double bias = std::abs(s.step_bias->potential.value / done.statistics.energies.potential());
  return std::max(ratio, bias / settings.max_bias);
}

/// Chooses the time step, unless it was given. It is half of the maximum stable step, or a shorter
/// step within all bounds. They grow as the square of the step.
bool choose_step(Chain& chain, Replica& replica) {
  constexpr std::uint64_t trials = 8;
  constexpr double shorter = 1.5;
  if (chain.settings().given_step > 0) {
    replica.step = chain.settings().given_step;
    return true;
  }
  const State start = chain.system().state;
  const double compressibility = compressibility_of_moves(replica, chain.settings().at);
  const TrajectorySettings probe = averages_of(chain, compressibility, first_step, 1, 0);
  double step = rounded(max_stable_step(chain.system(), start, probe) / 2);
  for (std::uint64_t k = 1; k <= trials; ++k) {
    replica.step = step;
    const TrajectorySettings trial =
        averages_of(chain, compressibility, step, 2 * steps_of_averages, averaging - k);
    const Trajectory done = chain.attempt(trial);
    if (done.stopped) return false;
    double beyond = shorter * shorter;
    if (done.failure.empty()) {
      beyond = beyond_bounds(summary(chain.system(), trial, done), done, chain.settings());
      if (beyond <= 1) return true;
    } else {
      chain.system().state = start;
    }
    step = rounded(step /
                   std::min(shorter, std::sqrt(beyond)));  // far beyond the bound, R grows faster
  }
  replica.step = step;
  return true;
}

/// All correlation functions of a segment of dynamics, one after the other; nothing if it was
/// stopped.
/// @param parts  of each step of the replica, with the same samples
std::optional<BlockMeans::Block> correlations(Chain& chain, double whole_step, std::size_t parts,
                                              std::uint64_t stream) {
  const System& system = chain.system();
  TrajectorySettings t = segment_of_dynamics(chain, whole_step, parts, stream);
  constexpr std::size_t every = 2, frame = steps_of_lags / lags / every;  // intervals in samples
  t.sample = every * whole_step;
  Displacement displacement(system.topology, lags);
  Reorientation rotation(system.topology, lags);
  LowFrequencySpectrum<pressure_components> spectrum(steps_of_lags * windows_in_segment / every,
                                                     t.sample);
  Distances distances = Distances::within(system.topology, system.state.box);
  constexpr std::size_t frames_of_distances = 10;  // distances change less than their pairs cost
  std::size_t samples = 0, frames = 0;
  const auto load = [&](const State& state, const Load& forces) {
    spectrum.add(independent_components(pressure_tensor(state, system.bodies, forces)));
    if (samples++ % frame != 0) return;
    if (frames++ % frames_of_distances == 0) distances.add(state);
    displacement.add(state);
    rotation.add(state);
  };
  if (!chain.run(t, {.load = load})) return std::nullopt;
  BlockMeans::Block segment;
  const auto append = [&](const BlockMeans& correlation) {
    const BlockMeans::Block all = correlation.sum();
    segment.weight = all.weight;
    segment.sum.insert(segment.sum.end(), all.sum.begin(), all.sum.end());
  };
  const auto append_means = [&](const std::vector<double>& means) {
    for (const double mean : means) segment.sum.push_back(mean * segment.weight);
  };
  for (std::size_t part = 0; part < system.topology.parts.size(); ++part) {
    append(displacement.mean_square(part));
    for (std::size_t axis = 0; axis < rotation.axes(part).size(); ++axis)
      append(rotation.legendre(part, axis, 2));
  }
  append_means(spectrum.means(pressure_bins()));
  append_means(distances.means());
  return segment;
}

/// The mean-square displacements along the axes of a segment in the long box; nothing if it was
/// stopped.
std::optional<BlockMeans::Block> displacements(Chain& chain, double whole_step, std::size_t parts,
                                               std::uint64_t stream) {
  TrajectorySettings t = segment_of_dynamics(chain, whole_step, parts, stream);
  constexpr std::size_t steps_of_lag = steps_of_lags / lags;
  t.sample = whole_step * static_cast<double>(steps_of_lag);
  Displacement displacement(chain.system().topology, lags);
  const auto sample = [&](std::size_t, const State& state, const Energies&) {
    displacement.add(state);
  };
  if (!chain.run(t, {.sample = sample})) return std::nullopt;
  BlockMeans::Block segment = displacement.mean_square_along(0, 0).sum();
  for (std::size_t axis = 1; axis < 3; ++axis) {
    const BlockMeans::Block along = displacement.mean_square_along(axis, 0).sum();
    segment.sum.insert(segment.sum.end(), along.sum.begin(), along.sum.end());
  }
  return segment;
}

}  // namespace

Config configuration_of(const ReplicaSettings& settings) {
  Config config = settings.config;
  SystemSettings& system = config.system;
  system.temperature = settings.at.temperature;
  if (!system.initial_configuration.empty()) return config;
  if (settings.at.constant_volume()) {
    system.box.reset();
    system.density = first_density(settings);
  } else if (!system.density && !system.box) {
    system.density = settings.liquid_density;
  }
  return config;
}

DynamicsChain* chain_of(Replica& replica, MeasuredIn kind) {
  if (!is_dynamics(kind)) return nullptr;
  return kind == MeasuredIn::dynamics    ? &replica.dynamics
         : kind == MeasuredIn::elongated ? &replica.elongated
                                         : &replica.conduction;
}

std::size_t length_of(const Replica& replica, MeasuredIn kind) {
  return with_segments(replica, kind, [](const auto& list) { return list.size(); });
}

void shorten(Replica& replica, MeasuredIn kind, std::size_t segments) {
  with_segments(replica, kind, [&](auto& list) { list.resize(std::min(list.size(), segments)); });
}

bool prepare(Replica& replica, const ReplicaSettings& settings) {
  Replica prepared{.index = replica.index,
                   .compressibility = settings.config.ensemble.barostat
                                          ? settings.config.ensemble.barostat->compressibility
                                          : default_compressibility()};
  Chain chain(settings, prepared, prepared.meshes);
  if (!relax(chain, prepared)) return false;
  prepared.step = settings.step;
  if (settings.step == 0 && !choose_step(chain, prepared)) return false;
  prepared.state = chain.system().state;
  prepared.state.time = 0;
  replica = std::move(prepared);
  return true;
}

bool add_averages(Replica& replica, const ReplicaSettings& settings) {
  Chain chain(settings, replica, replica.meshes);
  System& system = chain.system();
  system.state = replica.state;
  const TrajectorySettings t =
      sampling_of(chain, compressibility_of_moves(replica, settings.at), replica.step,
                  steps_of_averages, averaging + replica.averages.size());
  const auto fixed = t.fixed_means();
  const bool constant_volume = settings.at.constant_volume();
  const std::size_t count = constant_volume ? averages_count_at_constant_volume : averages_count;
  AveragesSegment segment{.sums = {0, std::vector<double>(count)}, .response = {}};
  LongestWaves waves;
  if (replica.averages.empty()) replica.start = in_fractions(system.state);
  TimeBlocks part;
  constexpr std::size_t samples_of_part = steps_of_averages / steps_of_sample / parts_of_averages;
  if (!replica.averages.empty()) segment.response.first = replica.averages.front().response.first;
  const auto sample = [&](std::size_t steps, const State& state, const Energies& now) {
    if (steps == 0) return;  // the last sample of the previous segment
    const double U = now.potential(), V = now.volume;
    const std::array<double, averages_count_at_constant_volume> values{
        U, V, U * U, V * V, U * V, norm2(total_dipole(state, system.topology)), now.pressure};
    const std::span x(values.data(), count);
    waves.add(state);
    segment.sums.weight += 1;
    for (std::size_t k = 0; k < x.size(); ++k) segment.sums.sum[k] += x[k];
    part.add(std::array{U, V});
    if (steps % (samples_of_part * steps_of_sample) == 0) {
      const std::vector<double> mean = std::exchange(part, {}).means().mean();
      segment.potentials.push_back(mean[0]);
      segment.volumes.push_back(mean[1]);
    }
    if (fixed && !std::isnan(now.step_error)) segment.response.add(step_error(now, *fixed, 0), x);
  };
  if (!chain.run(t, {.sample = sample})) return false;
  segment.response.blocks = {{segment.response.blocks.means().sum()}, 1};
  check_liquid(system.state, system.topology.mass(), settings);
  check_one_phase(waves, system.state.size(), settings.at);
  const std::size_t segments = replica.averages.size() + 1;
  if (segments >= first_averages)
    check_motion(system.state, system.bodies, replica.start,
                 replica.step * static_cast<double>(segments * steps_of_averages), settings.at);
  replica.state = system.state;
  replica.averages.push_back(std::move(segment));
  return true;
}

bool add_dynamics(Replica& replica, const ReplicaSettings& settings) {
  Chain chain(settings, replica, replica.meshes);
  DynamicsChain& dynamics = replica.dynamics;
  chain.system().state = dynamics.state.value_or(replica.state);
  if (!dynamics.state) scale_to_mean(chain, replica);
  return extend(dynamics, chain, replica.step, moving, pairing, correlations);
}

bool add_elongated(Replica& replica, const ReplicaSettings& settings) {
  DynamicsChain& elongated = replica.elongated;
  Chain chain(settings, replica, elongated.meshes);
  if (!begin_copies(chain, replica, elongated.state, elongate, relaxing_elongated)) return false;
  return extend(elongated, chain, replica.step, elongating, elongated_pairing, displacements);
}

}  // namespace polhode
