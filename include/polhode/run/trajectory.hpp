// SPDX-License-Identifier: MIT
// A trajectory: steps of a scheme, energies at intervals, a watch on what goes wrong.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "polhode/base/workers.hpp"
#include "polhode/integrate/nested_scheme.hpp"
#include "polhode/measure/energy.hpp"
#include "polhode/run/system.hpp"

namespace polhode {

struct TrajectorySettings {
  Scheme scheme;
  double step = 0;                     ///< [ps]
  double length = 0;                   ///< [ps]
  double sample = 0;                   ///< between energies [ps]; at least one step
  double lambda = 1e-4;                ///< of finite-difference gradients
  std::optional<InnerScheme> inner{};  ///< within the drifts of the scheme

  std::size_t steps() const;
  std::size_t steps_per_sample() const;
};

/// What may be done along the way; both are optional.
struct Watch {
  /// Called at every sample with the number of steps done.
  std::function<void(std::size_t steps, const State&, const Energies&)> sample;
  /// Asked after every step; true ends the trajectory there, with a last sample.
  std::function<bool()> stop;
};

/// Seconds of wall-clock time by part.
struct Timings {
  double forces = 0;       ///< without the list; all of them
  double near = 0;         ///< near forces of an inner scheme, without their list
  double list = 0;         ///< neighbour lists: checks and rebuilds
  double motion = 0;       ///< drifts and kicks
  double measurement = 0;  ///< energies, output
  double all() const { return forces + near + list + motion + measurement; }
};

struct Trajectory {
  std::vector<Energies> samples;  ///< the first at the start
  std::size_t steps = 0;
  std::uint64_t force_evaluations = 0;  ///< by the scheme
  std::uint64_t near_evaluations = 0;   ///< of the near forces of an inner scheme
  std::uint64_t measurements = 0;       ///< force evaluations for energies alone
  bool stopped = false;                 ///< by the watch
  std::string failure;                  ///< why it ended early by itself; empty if it did not
  Timings timings;
};

/// Moves the system's state along. Total energy is sampled at synchronised steps. A trajectory that
/// blows up ends there and says so, with the step and what to try, in `failure`: an energy is not
/// finite, or the total energy has changed by more than the kinetic energy at the start. The
/// trajectory is the same for any number of threads.
Trajectory trajectory(System& system, ForceField& forces, const TrajectorySettings& settings,
                      const Watch& watch = {}, Workers& workers = Workers::serial());

/// Prepares a system at its temperature: a trajectory with velocities rescaled at intervals, and
/// the total momentum removed. The step is at most 1 fs, so that rough starts relax.
/// @return  false if the watch stopped it
/// @throws RunError  if it blows up
bool equilibrate(System& system, ForceField& forces, double length, const Watch& watch = {},
                 Workers& workers = Workers::serial());

}  // namespace polhode
