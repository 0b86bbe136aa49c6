// SPDX-License-Identifier: MIT
#include "candidate_time.hpp"

#include "polhode/base/stopwatch.hpp"
#include "polhode/run/simulation/trajectory.hpp"

namespace polhode {

double time_of(const Candidate& candidate, System system, const Config& config, double seconds,
               const std::function<bool()>& stop, Workers& workers) {
  const auto stopped = [&] { return stop && stop(); };
  ForceField forces(system.topology, system.forces, system.state.box, workers);
  const Stopwatch watch;
  const auto over = [&] { return stopped() || watch.seconds() > seconds; };
  // Twenty to a thousand steps at a time, including a few list rebuilds.
  const double min_duration = 20 * candidate.step;
  const TrajectorySettings s{candidate.scheme, candidate.step, 1000 * candidate.step,
                             config.run.sample, config.integrator.lambda};
  double length = 0, spent = 0;
  do {
    const Trajectory t = run_trajectory(system, forces, s, {nullptr, over}, workers);
    length += static_cast<double>(t.steps) * s.step;
    spent += t.timings.all();
  } while (length < min_duration && !stopped());
  return spent / length;
}

}  // namespace polhode
