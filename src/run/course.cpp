// SPDX-License-Identifier: MIT
#include "polhode/run/course.hpp"

#include <utility>

namespace polhode {

Outcome moved(Course& course, TrajectorySettings settings, const ForceNoise& noise,
              const std::function<bool()>& stop) {
  settings.seed = course.seed;
  System& system = course.system;
  ForceField forces(system.topology, system.forces, system.state.box);
  RunState end;
  const Watch watch{nullptr, stop, nullptr, [&](RunState now) { end = std::move(now); }};
  const Trajectory t = trajectory(system, forces, settings, watch, Workers::serial(),
                                  course.state ? &*course.state : nullptr);
  course.state = std::move(end);
  Outcome run = outcome(system, t);
  if (run.failure.empty())
    run.rounding = rounding_fluctuation(noise, settings.scheme, settings.lambda, settings.step,
                                        settings.length) /
                   t.statistics.energies.potential_fluctuation();
  return run;
}

}  // namespace polhode
