// SPDX-License-Identifier: MIT
// A trajectory under way: a scheme that advances a system, and the statistics of its energies.
#pragma once

#include <memory>

#include "polhode/run/simulation/trajectory/trajectory.hpp"

namespace polhode {

/// Advances a system step by step. The results, to the last bit, and the sampled steps do not
/// depend on how the steps are divided among calls.
class Propagator {
 public:
  /// @param system, forces, workers  kept by reference
  /// @throws Error  if the near forces of an inner scheme are not compatible with the full forces
  Propagator(System& system, ForceField& forces, const TrajectorySettings& settings,
             Workers& workers = Workers::serial());
  ~Propagator();
  Propagator(const Propagator&) = delete;
  Propagator& operator=(const Propagator&) = delete;

  /// Resumes from a stored state, bit for bit as if the run had never been suspended.
  void resume_from(const RunState& state);
  /// The state that determines the remaining trajectory. This state does not include the last
  /// sample of run(), because a longer trajectory would not have this sample.
  RunState run_state();

  /// Takes steps, and takes samples at the sampling intervals. The first sample is taken at the
  /// start. Of the callbacks in `watch`, the function calls only `sample` and `stop`.
  /// @throws RunError  if the trajectory blows up
  void advance(std::size_t steps, const Watch& watch = {});
  /// Continues the trajectory to the length given in the settings, or until `watch.stop` ends it. A
  /// last sample is taken at the end. If the trajectory blows up, the function returns, and
  /// `failure` reports the cause.
  Trajectory run(const Watch& watch = {});

  /// Heat and work that the bodies have received so far from thermostat, barostat and hybrid Monte
  /// Carlo [kJ/mol].
  double exchanged() const;

  /// Number of steps done since the start of the trajectory.
  std::size_t steps() const;
  const Segment& segment() const;
  /// The statistics, counts and timings of the trajectory so far.
  Trajectory trajectory();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace polhode
