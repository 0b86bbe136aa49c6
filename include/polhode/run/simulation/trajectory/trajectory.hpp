// SPDX-License-Identifier: MIT
// A trajectory: steps of a scheme, energies at intervals, and checks for a failing simulation.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "polhode/base/workers.hpp"
#include "polhode/ensemble/barostat.hpp"
#include "polhode/ensemble/hybrid_monte_carlo.hpp"
#include "polhode/integrate/integrator.hpp"
#include "polhode/measure/energy_statistics.hpp"
#include "polhode/run/simulation/system/system.hpp"
#include "polhode/run/simulation/trajectory/trajectory_settings.hpp"

namespace polhode {

/// Wall-clock time by part of the program [s].
struct Timings {
  double forces = 0;       ///< all forces, without the neighbour list
  double list = 0;         ///< neighbour lists: checks and rebuilds
  double motion = 0;       ///< drifts and kicks
  double measurement = 0;  ///< energies, output
  double near = 0;         ///< near forces of an inner scheme, without their neighbour list
  double all() const { return forces + near + list + motion + measurement; }
};

/// State of thermostat, barostat and hybrid Monte Carlo, and the heat and work that they have given
/// so far.
struct EnsembleMemory {
  double heat = 0;  ///< heat from the thermostat [kJ/mol]
  BarostatMemory barostat;
  HybridMonteCarloMemory hybrid;
  double exchanged() const {
    return heat + barostat.work + hybrid.work;
  }  ///< total heat and work [kJ/mol]
};

/// A part of a trajectory with constant settings. If the caller changes the settings or the state,
/// a new segment begins. Each segment has separate statistics, costs, heat and work.
struct Segment {
  std::uint64_t number = 1;
  std::size_t first_step = 0;  ///< number of trajectory steps before the segment
  double earlier = 0;          ///< time simulated before the segment [ps]
  std::string changes;  ///< change that began the segment, such as "integrator.step was 2 fs and is
                        ///< now 1 fs"
};

/// The state of a run between two steps. This state determines the continuation of the run to the
/// last bit.
struct RunState {
  State state;
  std::optional<double> equilibrated;  ///< equilibration time so far [ps]; empty after the start of
                                       ///< the trajectory
  std::size_t steps = 0;
  double start = 0;                 ///< time of the state at the first step of the segment [ps]
  IntegratorMemory integrator;      ///< empty during equilibration
  ListMemory list, near_list;       ///< neighbour lists of all forces, and of the near forces of an
                                    ///< inner scheme
  TrajectoryStatistics statistics;  ///< statistics so far
  Timings timings;
  EnsembleMemory ensemble;
  Segment segment;
};

/// The time simulated in a number of steps [ps]. Steps before the present segment may have had a
/// different length.
double simulated(const TrajectorySettings& settings, const Segment& segment, std::size_t steps);
/// The step at which a trajectory of the length given in the settings ends.
std::size_t last_step(const TrajectorySettings& settings, const Segment& segment);

/// Callbacks during a trajectory, all of them optional.
struct Watch {
  /// Called at every sample, with the number of steps done.
  std::function<void(std::size_t steps, const State&, const Energies&)> sample;
  /// Called after every step. If `stop` returns true, the trajectory ends with a last sample.
  std::function<bool()> stop;
  /// Called after every step. If this function returns true, `checkpoint` is called. In addition,
  /// `checkpoint` is called at the start, when `stop` ends the trajectory, and at the end.
  std::function<bool()> due;
  std::function<void(RunState)> checkpoint;
  /// Called at each sample that has error brackets.
  std::function<void(const BracketSample&)> brackets;
  /// Called at every sample, before `sample`, with the forces, energies and virial at the state.
  std::function<void(const State&, const Load&)> load{};
};

struct Trajectory {
  TrajectoryStatistics statistics;
  std::size_t steps = 0;
  Segment segment;                      ///< segment to which all counts except `steps` belong
  std::uint64_t force_evaluations = 0;  ///< number of force evaluations by the scheme
  std::uint64_t derivatives = 0;        ///< number of derivative evaluations by the scheme
  std::uint64_t near_evaluations = 0;   ///< number of near-force evaluations of an inner scheme
  std::uint64_t near_derivatives = 0;
  std::uint64_t measurements = 0;  ///< number of force evaluations that only measure energies
  EnsembleMemory ensemble;
  bool stopped = false;  ///< whether `stop` ended the trajectory
  std::string failure;   ///< message with cause, time and remedy of a blow-up; otherwise empty
  std::string cause;     ///< cause of the failure, with the two molecules that collided
  std::size_t list_rebuilds = 0;  ///< number of rebuilds of the neighbour list, including rebuilds
                                  ///< before the first step
  Timings timings;
};

/// Advances the state of a system along a trajectory. Total energy is sampled at synchronized
/// steps. The trajectory is the same for any number of threads. A trajectory that blows up ends
/// early, and `failure` then reports the step and remedies. A trajectory has blown up if an energy
/// is not finite, or if the total energy has changed by more than the initial kinetic energy. The
/// final sample may lie between two sampling times. A longer trajectory then does not contain this
/// sample.
/// @param from  state to resume from, bit for bit as if the trajectory had never been suspended
Trajectory run_trajectory(System& system, ForceField& forces, const TrajectorySettings& settings,
                          const Watch& watch = {}, Workers& workers = Workers::serial(),
                          const RunState* from = nullptr);

/// Equilibrates a system at its temperature. First, overlapping molecules are moved apart
/// (separate_molecules()). Then a trajectory is run in which velocities are rescaled at intervals
/// and the total momentum is removed. The time step is at most 1 fs, so that rough initial
/// configurations can relax. Checkpoints are taken between two rescalings.
/// @return false if `stop` ended the equilibration
/// @throws RunError  if the trajectory blows up
bool equilibrate(System& system, ForceField& forces, double length, const Watch& watch = {},
                 Workers& workers = Workers::serial(), const RunState* from = nullptr);

}  // namespace polhode
