// SPDX-License-Identifier: MIT
#include "run/properties/chain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "measure/finite_size.hpp"
#include "polhode/base/error.hpp"
#include "polhode/base/units.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/integrate/with_bath.hpp"
#include "polhode/math/random.hpp"
#include "run/simulation/system/relaxation.hpp"

namespace polhode {
namespace {

/// @throws RunError  if nearly all trajectories are rejected
void check_acceptance(const HybridMonteCarloMemory& hybrid, const StatePoint& at) {
  constexpr std::uint64_t min_trajectories = 20, one_in = 10;
  if (hybrid.trajectories < min_trajectories || one_in * hybrid.accepted >= hybrid.trajectories)
    return;
  throw RunError(
      fmt::format("at {}: hybrid Monte Carlo accepts only {} of {} trajectories; give a shorter "
                  "step, fewer molecules, or the sampling molecular-dynamics",
                  at.text(), hybrid.accepted, hybrid.trajectories));
}

double relaxation_time(double step) { return std::max(2.0, 100 * step); }  // of the volume [ps]

/// The scheme with a bath at the ends of its steps.
Scheme with_ends(const ReplicaSettings& settings) {
  const std::string name = settings.scheme + " with a bath";
  return with_bath(scheme_of(settings.scheme), BathPlace::ends,
                   name.size() <= Scheme::max_name ? name : "own scheme with a bath");
}

}  // namespace

Chain::Chain(const ReplicaSettings& settings, const Replica& replica,
             std::optional<MeshChoice>& meshes)
    : settings_(settings), config_(configuration_of(settings)), meshes_(meshes) {
  config_.system.seed = derived_seed(config_.system.seed, replica.index);
  config_.run.minimise = true;
  system_.emplace(build_system(config_));
}

std::uint64_t Chain::seed(std::uint64_t stream) const {
  return derived_seed(config_.system.seed, stream);
}

TrajectorySettings Chain::trajectory(const Scheme& scheme, double step, double length,
                                     std::uint64_t stream) const {
  TrajectorySettings t{.scheme = scheme,
                       .step = step,
                       .length = length,
                       .sample = 10 * step,
                       .lambda = config_.integrator.lambda,
                       .seed = seed(stream)};
  t.ensemble.temperature = settings_.at.temperature;
  return t;
}

Trajectory Chain::attempt(const TrajectorySettings& t, Watch watch) {
  watch.stop = settings_.stop;
  ForceField forces(system_->topology, system_->forces, system_->state.box, Workers::serial(),
                    std::exchange(meshes_, std::nullopt));
  try {
    Trajectory done = run_trajectory(*system_, forces, t, watch);
    meshes_ = forces.mesh_choice();
    return done;
  } catch (const RunError& e) {  // a barostat that moves the box too far
    Trajectory ended;
    ended.failure = e.what();
    return ended;
  }
}

std::optional<Trajectory> Chain::run(const TrajectorySettings& t, Watch watch) {
  Trajectory done = attempt(t, std::move(watch));
  if (!done.failure.empty())
    throw RunError(fmt::format("at {}: {}", settings_.at.text(), done.failure));
  if (done.stopped) return std::nullopt;
  check_acceptance(done.ensemble.hybrid, settings_.at);
  return done;
}

TrajectorySettings segment_of_dynamics(const Chain& chain, double whole_step, std::size_t parts,
                                       std::uint64_t stream) {
  TrajectorySettings t = chain.trajectory(
      with_ends(chain.settings()), whole_step / static_cast<double>(parts),
      whole_step * static_cast<double>(steps_of_lags * windows_in_segment), stream);
  t.ensemble.thermostat = Rescaling{std::max(2.0, 500 * whole_step)};
  return t;
}

bool extend(DynamicsChain& segments, Chain& chain, double step, std::uint64_t stream,
            std::uint64_t stream_of_pairs, SegmentOfDynamics& simulate) {
  const std::size_t k = segments.segments.size();
  State& state = chain.system().state;
  const State start = state;
  const auto segment = simulate(chain, step, 1, stream + k);
  if (!segment) return false;
  const State end = state;
  if (chain.settings().paired_runs && k % paired_every == 0) {
    state = start;
    const auto paired = simulate(chain, step, 2, stream_of_pairs + k);
    if (!paired) return false;
    segments.paired.push_back({k, *paired});
  }
  segments.state = end;
  segments.segments.push_back(*segment);
  return true;
}

ForceSettings Chain::force_settings() {
  ForceField forces(system_->topology, system_->forces, system_->state.box, Workers::serial(),
                    std::exchange(meshes_, std::nullopt));
  meshes_ = forces.mesh_choice();
  return forces.settings();
}

void scale_to(State& state, double volume) {
  const double factor = std::cbrt(volume / state.box.volume());
  for (std::size_t i = 0; i < state.size(); ++i) state.q.set(i, factor * state.q[i]);
  state.box = Box{factor * state.box.edge};
}

void scale_to_mean(Chain& chain, const Replica& replica) {
  if (chain.settings().at.constant_volume()) return;
  const std::size_t from = equilibrated(replica);
  double V = 0;
  for (std::size_t k = from; k < replica.averages.size(); ++k)
    V += replica.averages[k].sums.sum[volume] / replica.averages[k].sums.weight;
  scale_to(chain.system().state, V / static_cast<double>(replica.averages.size() - from));
}

void stack(System& system, std::size_t copies) {
  const State one = system.state;
  Box box = one.box;
  box.edge.z *= static_cast<double>(copies);
  State& all = system.state = State(copies * one.size(), box);
  std::size_t first = 0, to = 0;
  for (auto& [molecule, count] : system.topology.parts) {
    for (std::size_t copy = 0; copy < copies; ++copy)
      for (std::size_t i = first; i < first + count; ++i, ++to) {
        const double up = static_cast<double>(copy) * one.box.edge.z;
        all.q.set(to, one.q[i] + Vec3<double>{0, 0, up});
        all.orientation.set(to, one.orientation[i]);
      }
    first += count;
    count *= copies;
  }
  system.bodies = Bodies(system.topology);
}

void elongate(System& system) {
  stack(system, elongated_copies);
  State& state = system.state;
  const Vec3<double> before = state.box.edge;
  const double side = std::cbrt(state.box.volume() / orthoboxy_ratio);
  const Vec3<double> edge{side, side, orthoboxy_ratio * side};
  const Vec3<double> factor{edge.x / before.x, edge.y / before.y, edge.z / before.z};
  for (std::size_t i = 0; i < state.size(); ++i) state.q.set(i, scaled(factor, state.q[i]));
  state.box = Box{edge};
}

bool begin_copies(Chain& chain, const Replica& replica, const std::optional<State>& last,
                  void (*make)(System&), std::uint64_t stream) {
  constexpr std::size_t steps = 5000;
  State& state = chain.system().state = replica.state;
  if (!last) scale_to_mean(chain, replica);
  make(chain.system());
  if (last) {
    state = *last;
    return true;
  }
  check_separated(chain.system(), minimise(chain.system(), relaxed_start));
  draw_momenta(chain.system(),
               derived_seed(chain.settings().config.system.seed, stream + replica.index));
  TrajectorySettings t = chain.trajectory(with_ends(chain.settings()), replica.step,
                                          replica.step * static_cast<double>(steps), stream);
  t.ensemble.thermostat = Langevin{0.01 / replica.step, 0.01 / replica.step};
  return chain.run(t).has_value();
}

BarostatSettings barostat(const ReplicaSettings& settings, double compressibility, double step) {
  BarostatSettings b{.type = CellRescaling{relaxation_time(step)},
                     .pressure = settings.at.pressure};
  b.compressibility = compressibility;
  b.every = 25 * step;
  return b;
}

double compressibility_of_moves(const Replica& replica, const StatePoint& at) {
  constexpr double min_relaxations = 8, max_change = 16;
  const std::size_t end = std::bit_floor(replica.averages.size());
  const std::size_t later_half = end / 2;
  const double length = static_cast<double>((end - later_half) * steps_of_averages) * replica.step;
  if (end < 2 || length < min_relaxations * relaxation_time(replica.step))
    return replica.compressibility;
  double weight = 0, V = 0, V2 = 0;
  for (std::size_t k = later_half; k < end; ++k) {
    const BlockMeans::Block& sums = replica.averages[k].sums;
    weight += sums.weight;
    V += sums.sum[volume];
    V2 += sums.sum[volume_squared];
  }
  V /= weight;
  const double measured = (V2 / weight - V * V) / (units::boltzmann * at.temperature * V);
  return std::clamp(measured, replica.compressibility / max_change,
                    max_change * replica.compressibility);
}

TrajectorySettings averages_of(const Chain& chain, double compressibility, double step,
                               std::size_t steps, std::uint64_t stream) {
  TrajectorySettings t = chain.trajectory(with_ends(chain.settings()), step,
                                          step * static_cast<double>(steps), stream);
  t.sample = step * steps_of_sample;
  t.shadow_sample = step * steps_of_shadow_sample;
  t.ensemble.thermostat = Rescaling{std::max(0.5, 100 * step)};
  if (!chain.settings().at.constant_volume())
    t.ensemble.barostat = barostat(chain.settings(), compressibility, step);
  return t;
}

TrajectorySettings sampling_of(const Chain& chain, double compressibility, double step,
                               std::size_t steps, std::uint64_t stream) {
  TrajectorySettings t = averages_of(chain, compressibility, step, steps, stream);
  if (chain.settings().sampling == Sampling::molecular_dynamics) return t;
  t.scheme = scheme_of(chain.settings().scheme);
  t.ensemble.thermostat.reset();
  t.ensemble.hybrid_monte_carlo = HybridMonteCarloSettings{.steps = steps_of_sample};
  return t;
}

}  // namespace polhode
