// SPDX-License-Identifier: MIT
#include "candidate_time.hpp"

#include <algorithm>

#include "base/stopwatch.hpp"
#include "polhode/run/simulation/trajectory/trajectory.hpp"

namespace polhode {
namespace {

/// The wall-clock time per simulated ps of a candidate at its step [s], measured for about
/// `seconds`.
double time_of(const Candidate& candidate, System system, const Config& config, double seconds,
               const std::function<bool()>& stop, Workers& workers) {
  const auto stopped = [&] { return stop && stop(); };
  ForceField forces(system.topology, system.forces, system.state.box, workers);
  const Stopwatch watch;
  const auto over = [&] { return stopped() || watch.seconds() > seconds; };
  // Each measurement consists of 20 to 1000 steps, including a few list rebuilds.
  const double min_duration = 20 * candidate.step;
  const TrajectorySettings s{candidate.scheme, candidate.step, 1000 * candidate.step,
                             config.run.sample, config.integrator.lambda};
  double length = 0, spent = 0;
  bool blew_up = false;
  do {
    const Trajectory t = run_trajectory(system, forces, s, {nullptr, over}, workers);
    length += static_cast<double>(t.steps) * s.step;
    spent += t.timings.all();
    blew_up = !t.failure.empty();
  } while (length < min_duration && !blew_up && !stopped());
  return spent / length;
}

}  // namespace

void time_candidates(std::vector<Candidate>& candidates, const System& system, const Config& config,
                     double seconds, const std::function<void(const std::string&)>& report,
                     const std::function<bool()>& stop, Workers& workers) {
  constexpr int turns = 3;
  const double each =
      std::clamp(seconds / (turns * static_cast<double>(candidates.size())), 0.02, 0.3);
  std::vector<std::vector<double>> times(candidates.size());
  for (int turn = 0; turn < turns; ++turn)
    for (std::size_t c = 0; c < candidates.size() && !(stop && stop()); ++c) {
      if (candidates[c].step == 0 || candidates[c].seconds > 0) continue;
      report(candidates[c].name);
      times[c].push_back(time_of(candidates[c], system, config, each, stop, workers));
    }
  for (std::size_t c = 0; c < times.size(); ++c)
    if (!times[c].empty()) {
      std::sort(times[c].begin(), times[c].end());
      candidates[c].seconds = times[c][times[c].size() / 2];
    }
}

}  // namespace polhode
