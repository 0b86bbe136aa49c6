// SPDX-License-Identifier: MIT
#include "polhode/run/simulation/trajectory/trajectory.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "io/settings/output_units.hpp"
#include "polhode/base/error.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/run/simulation/trajectory/propagator.hpp"
#include "run/simulation/system/relaxation.hpp"

namespace polhode {

double simulated(const TrajectorySettings& settings, const Segment& segment, std::size_t steps) {
  return segment.earlier + static_cast<double>(steps - segment.first_step) * settings.step;
}

std::size_t last_step(const TrajectorySettings& settings, const Segment& segment) {
  return segment.first_step + settings.steps_in(std::max(0.0, settings.length - segment.earlier));
}

Trajectory run_trajectory(System& system, ForceField& forces, const TrajectorySettings& settings,
                          const Watch& watch, Workers& workers, const RunState* from) {
  Propagator propagator(system, forces, settings, workers);
  if (from) propagator.resume_from(*from);
  return propagator.run(watch);
}

bool equilibrate(System& system, ForceField& forces, double length, const Watch& watch,
                 Workers& workers, const RunState* from) {
  constexpr double step = 0.001, interval = 0.02;  // time step and interval between rescalings [ps]
  const Scheme scheme = scheme_of("velocity-verlet");
  const Watch within{watch.sample, watch.stop};
  double done = 0;
  if (from) {
    system.state = from->state;
    done = from->equilibrated.value();
    forces.resume_from(from->list, system.state.box);
  }
  const double begin = system.state.time - done;
  const auto resumable = [&] {
    return watch.checkpoint ? RunState{.state = system.state,
                                       .equilibrated = done,
                                       .list = forces.list_memory(system.state.box)}
                            : RunState{};
  };
  // If the equilibration was interrupted, the interrupted piece is repeated. The first piece begins
  // by separating overlapping molecules.
  RunState here = resumable();
  bool stopped = false;
  if (done == 0)
    separate_molecules(
        system, [&] { return stopped = watch.stop && watch.stop(); }, workers);
  while (!stopped && done < length) {
    rescale(system.state, system.topology, system.bodies, system.temperature);
    const double piece = std::min(interval, length - done);
    const Trajectory part = run_trajectory(
        system, forces, {scheme, step, std::max(piece, step), interval}, within, workers);
    done += piece;
    if (!part.failure.empty())
      throw RunError(fmt::format(
          "the equilibration blew up after {:.4f} ps, in steps of {:g} fs: {}; use a lower "
          "density, or another initial configuration",
          system.state.time - begin, step * units::fs_per_ps, part.cause));
    stopped = part.stopped;
    if (stopped) break;
    if (watch.checkpoint && watch.due && watch.due()) watch.checkpoint(here);
    here = resumable();
  }
  if (stopped) {
    if (watch.checkpoint) watch.checkpoint(std::move(here));
    return false;
  }
  rescale(system.state, system.topology, system.bodies, system.temperature);
  system.state.time = 0;
  return true;
}

}  // namespace polhode
