// SPDX-License-Identifier: MIT
// A trajectory: steps of a scheme, energies at intervals, a watch on what goes wrong.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "polhode/base/workers.hpp"
#include "polhode/ensemble/barostat.hpp"
#include "polhode/ensemble/hybrid_monte_carlo.hpp"
#include "polhode/integrate/integrator.hpp"
#include "polhode/measure/energy_statistics.hpp"
#include "polhode/run/simulation/system/system.hpp"
#include "polhode/run/simulation/trajectory/trajectory_settings.hpp"

namespace polhode {

/// Seconds of wall-clock time by part.
struct Timings {
  double forces = 0;       ///< all forces, without the list
  double list = 0;         ///< neighbour lists: checks and rebuilds
  double motion = 0;       ///< drifts and kicks
  double measurement = 0;  ///< energies, output
  double near = 0;         ///< near forces of an inner scheme, without their list
  double all() const { return forces + near + list + motion + measurement; }
};

/// What thermostat, barostat and hybrid Monte Carlo have done so far.
struct EnsembleMemory {
  double heat = 0;  ///< heat from the thermostat [kJ/mol]
  BarostatMemory barostat;
  HybridMonteCarloMemory hybrid;
  double exchanged() const { return heat + barostat.work + hybrid.work; }  ///< [kJ/mol]
};

/// A part of a trajectory with the same settings. A change of the settings or of the state from
/// outside begins the next one, which has statistics, costs, heat and work of its own.
struct Segment {
  std::uint64_t number = 1;
  std::size_t first_step = 0;  ///< steps of the trajectory before it
  double earlier = 0;          ///< time simulated before it [ps]
  std::string changes;  ///< what began it, such as "integrator.step was 2 fs and is now 1 fs"
};

/// The state of a run between two steps, on which its continuation depends to the last bit.
struct RunState {
  State state;
  std::optional<double> equilibrated;  ///< time so far [ps]; empty after the start
  std::size_t steps = 0;
  double start = 0;                 ///< time of the state at the first step of the segment [ps]
  IntegratorMemory integrator;      ///< empty while equilibrating
  ListMemory list, near_list;       ///< the second for an inner scheme's near forces
  TrajectoryStatistics statistics;  ///< statistics so far
  Timings timings;
  EnsembleMemory ensemble;
  Segment segment;
};

/// The time simulated in a number of steps [ps], of which the last ones are in this segment.
double simulated(const TrajectorySettings& settings, const Segment& segment, std::size_t steps);
/// The step at which a trajectory with the length of the settings ends.
std::size_t last_step(const TrajectorySettings& settings, const Segment& segment);

/// Callbacks during a trajectory, all of them optional.
struct Watch {
  /// Called at every sample with the number of steps done.
  std::function<void(std::size_t steps, const State&, const Energies&)> sample;
  /// Called after every step; true ends the trajectory there, with a last sample.
  std::function<bool()> stop;
  /// Called after every step: whether to call `checkpoint` then. `checkpoint` is called in any case
  /// at the start, when `stop` ends the trajectory, and at the end.
  std::function<bool()> due;
  std::function<void(RunState)> checkpoint;
  /// Called at samples that have error brackets.
  std::function<void(const BracketSample&)> brackets;
  /// Called at every sample, before `sample`, with the forces, energies and virial at the state.
  std::function<void(const State&, const Load&)> load{};
};

struct Trajectory {
  TrajectoryStatistics statistics;
  std::size_t steps = 0;
  Segment segment;                      ///< segment of all counts but `steps`
  std::uint64_t force_evaluations = 0;  ///< force evaluations by the scheme
  std::uint64_t derivatives = 0;        ///< derivatives of the forces by the scheme
  std::uint64_t near_evaluations = 0;   ///< evaluations of the near forces of an inner scheme
  std::uint64_t near_derivatives = 0;
  std::uint64_t measurements = 0;  ///< force evaluations for energies alone
  EnsembleMemory ensemble;
  bool stopped = false;           ///< whether the watch stopped it
  std::string failure;            ///< why it blew up, when, and what to try; empty if it did not
  std::string cause;              ///< cause of the failure, with the two molecules that collided
  std::size_t list_rebuilds = 0;  ///< rebuilds of the neighbour list, also before the first step
  Timings timings;
};

/// Advances the system's state. Total energy is sampled at synchronized steps. A trajectory that
/// blows up ends there: an energy is not finite, or the total energy has changed by more than the
/// kinetic energy at the start. `failure` reports the step and remedies. The trajectory is the same
/// for any number of threads. A final sample between two intervals, at the end or where it was
/// stopped, does not occur in a longer trajectory.
/// @param from  resumes from there, bit for bit as if it had never been suspended
Trajectory run_trajectory(System& system, ForceField& forces, const TrajectorySettings& settings,
                          const Watch& watch = {}, Workers& workers = Workers::serial(),
                          const RunState* from = nullptr);

/// Prepares a system at its temperature: molecules that overlap are moved apart
/// (separate_molecules()), then a trajectory with velocities rescaled at intervals, and the total
/// momentum removed. The step is at most 1 fs, so that rough initial configurations relax.
/// Checkpoints are taken between two rescalings.
/// @return  false if the watch stopped it
/// @throws RunError  if it blows up
bool equilibrate(System& system, ForceField& forces, double length, const Watch& watch = {},
                 Workers& workers = Workers::serial(), const RunState* from = nullptr);

}  // namespace polhode
