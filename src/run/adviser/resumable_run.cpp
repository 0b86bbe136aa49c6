// SPDX-License-Identifier: MIT
#include "run/adviser/resumable_run.hpp"

#include <utility>

namespace polhode {

Outcome advance_run(ResumableRun& resumable, TrajectorySettings settings, const ForceNoise& noise,
                    const std::function<bool()>& stop) {
  settings.seed = resumable.seed;
  System& system = resumable.system;
  ForceField forces(system.topology, system.forces, system.state.box);
  RunState end;
  const Watch watch{nullptr, stop, nullptr, [&](RunState now) { end = std::move(now); }};
  const Trajectory t = run_trajectory(system, forces, settings, watch, Workers::serial(),
                                      resumable.state ? &*resumable.state : nullptr);
  resumable.state = std::move(end);
  Outcome run = outcome(system, t);
  if (run.failure.empty())
    run.rounding = rounding_fluctuation(noise, settings.scheme, settings.lambda, settings.step,
                                        settings.length) /
                   t.statistics.energies.potential_fluctuation();
  return run;
}

}  // namespace polhode
