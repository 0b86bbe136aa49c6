// SPDX-License-Identifier: MIT
#include "polhode/run/course.hpp"

#include <utility>

namespace polhode {

Outcome moved(Course& course, TrajectorySettings settings, const ForceNoise& noise,
              const std::function<bool()>& stop) {
  settings.seed = course.seed;
  System& system = course.system;
  if (course.state)  // drop a final sample that is off the sampling interval
    course.samples.resize(course.state->steps / settings.steps_per_sample() + 1);
  ForceField forces(system.topology, system.forces, system.state.box);
  RunState end;
  const Watch watch{nullptr, stop, nullptr, [&](RunState now) { end = std::move(now); }};
  const Trajectory t =
      trajectory(system, forces, settings, watch, Workers::serial(),
                 course.state ? &*course.state : nullptr, std::move(course.samples));
  course.state = std::move(end);
  course.samples = t.samples;
  Outcome run = outcome(system, t);
  if (run.failure.empty()) {
    std::vector<double> potential;
    for (const Energies& e : t.samples) potential.push_back(e.potential());
    run.rounding = rounding_fluctuation(noise, settings.scheme, settings.lambda, settings.step,
                                        settings.length) /
                   fluctuation(potential);
  }
  return run;
}

}  // namespace polhode
