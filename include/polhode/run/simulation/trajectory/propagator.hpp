// SPDX-License-Identifier: MIT
// A trajectory under way: a scheme that advances a system, and the statistics of its energies.
#pragma once

#include <memory>

#include "polhode/run/simulation/trajectory/trajectory.hpp"

namespace polhode {

/// Advances a system step by step. Results do not depend on how the steps are divided among calls,
/// to the last bit: samples are taken at the same steps.
class Propagator {
 public:
  /// @param system, forces, workers  kept by reference
  /// @throws Error  if the near forces of an inner scheme do not fit the forces
  Propagator(System& system, ForceField& forces, const TrajectorySettings& settings,
             Workers& workers = Workers::serial());
  ~Propagator();
  Propagator(const Propagator&) = delete;
  Propagator& operator=(const Propagator&) = delete;

  /// Resumes from that state, bit for bit as if never suspended.
  void resume_from(const RunState& state);
  /// State on which the rest of the trajectory depends, without the last sample of run(), which a
  /// longer trajectory would not have.
  RunState run_state();

  /// Takes steps, with samples where they are due, the first one at the start. Of the watch,
  /// `sample` and `stop` are called.
  /// @throws RunError  if the trajectory blows up
  void advance(std::size_t steps, const Watch& watch = {});
  /// Continues to the length of the settings and takes a last sample there, or where the watch
  /// stops it. A trajectory that blows up ends there, and `failure` reports it.
  Trajectory run(const Watch& watch = {});

  /// Heat and work that the bodies have received from thermostat, barostat and hybrid Monte Carlo
  /// so far [kJ/mol].
  double exchanged() const;

  /// Steps done since the start of the trajectory.
  std::size_t steps() const;
  const Segment& segment() const;
  /// Statistics, counts and times so far.
  Trajectory trajectory();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace polhode
