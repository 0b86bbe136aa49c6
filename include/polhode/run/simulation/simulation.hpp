// SPDX-License-Identifier: MIT
// A simulation that a run file describes: in memory, step by step, or as a whole with output files.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "polhode/base/workers.hpp"
#include "polhode/io/settings/config.hpp"
#include "polhode/run/adviser/guarantee.hpp"
#include "polhode/run/callbacks.hpp"
#include "polhode/run/outputs.hpp"
#include "polhode/run/simulation/report/rounding.hpp"
#include "polhode/run/simulation/report/run_report.hpp"
#include "polhode/run/simulation/system/system.hpp"
#include "polhode/run/simulation/trajectory/propagator.hpp"

namespace polhode {

struct Checkpoint;
struct FoundCheckpoint;
class RunFiles;

/// The ways in which Simulation::run() can end. An interrupted equilibration or trajectory can be
/// resumed from a checkpoint. If an interrupt stops the search for the time step, no file is
/// written, and the next run starts a new search.
enum class RunEnd {
  complete,
  interrupted,                ///< interrupted during the trajectory
  interrupted_equilibrating,  ///< interrupted before the trajectory
  interrupted_choosing_step   ///< interrupted before the equilibration
};

struct RunResult {
  RunEnd end;
  std::optional<RunReport> report;  ///< report of the trajectory; empty if it did not start
};

/// The simulation that a run file describes: a system, an optional equilibration, and a trajectory.
/// The same trajectory, bit for bit, results from step(), from run(), after resuming, and with any
/// number of threads.
class Simulation {
 public:
  /// Builds the system. Construction neither computes anything nor writes a file.
  /// @param workers  threads, kept by reference
  /// @throws Error  with its place, if a setting or the initial configuration is invalid
  explicit Simulation(const Config& config, Workers& workers = Workers::serial());
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// The settings of the run file, with the scheme and step that choose_step() has chosen.
  const Config& config() const { return config_; }
  const System& system() const { return system_; }
  const State& state() const { return system_.state; }
  /// The state, which the caller may change between two steps. Call state_changed() after a change.
  /// The memory address of the state does not change until the end of the simulation.
  State& state_to_change();
  /// Begins a new segment of the trajectory after a change of the state, and evaluates the forces
  /// again. Orientations are normalized.
  /// @throws Error  if the state does not fit the molecules; only the orientations are then changed
  void state_changed();
  /// Begins a new segment of the trajectory with another scheme, step or ensemble. Momenta are not
  /// changed. If the run file requires an accuracy, a new step is chosen.
  /// @throws Error  if the settings do not suit each other or the forces, or if they add, remove or
  ///   change hybrid Monte Carlo; nothing is changed then
  void change(const IntegratorSettings& integrator, const EnsembleSettings& ensemble);
  /// Number of steps of the trajectory done so far.
  std::size_t steps() const;
  /// The present segment: the part of the trajectory with the present settings.
  Segment segment() const;
  /// The number of steps that run() takes, or that a run of a given time [ps] takes; see
  /// TrajectorySettings.
  std::size_t steps_left() const;
  std::size_t steps_in(double time) const;
  /// The energies of the current state, with the heat and work received so far. A separate force
  /// evaluation computes these energies, and does not affect the trajectory.
  Energies energies() const;
  /// Statistics of the present segment of the trajectory.
  RunSummary summary();
  /// The report of a trajectory in memory, with warnings, as run() returns it.
  RunReport report();

  /// Lets the adviser choose the time step if the run file requires an accuracy. The adviser also
  /// chooses the scheme if the run file has none. run() calls this function.
  /// @return  false if the search was interrupted
  /// @throws RunError  if no scheme meets the accuracy
  bool choose_step(const Callbacks& callbacks = {});
  /// Minimises and equilibrates once, as the run file requires. step() and run() call this
  /// function.
  /// @return  false if the equilibration was interrupted; another call resumes it
  /// @throws RunError  if the trajectory blows up
  bool equilibrate(const Callbacks& callbacks = {});
  /// Advances the trajectory in memory.
  /// @return  false if interrupted during the equilibration or between two steps
  /// @throws Error     if the run file requires an accuracy and the step is not chosen yet
  /// @throws RunError  if the trajectory blows up
  bool step(std::size_t steps = 1, const Callbacks& callbacks = {});

  /// Writes a checkpoint of the simulation.
  /// @param command  command that is recorded in the file
  /// @throws RunError  if the file cannot be written
  void save(const std::string& path, const std::string& command = "Simulation::save");
  /// Resumes from a checkpoint of the same run, which save() or run() has written. The program must
  /// have the same version and use the same instruction set as when the checkpoint was written.
  /// @throws Error  if the checkpoint is damaged, or belongs to another run, version or instruction
  ///   set
  void resume(const std::string& path);

  /// Continues the trajectory to the length that the run file requires. The function writes
  /// energies, trajectories, checkpoints, the final state and a figure. [output] selects files and
  /// names. Other processes cannot use these files, because a lock file protects them.
  /// @throws Error     before anything is computed, if outputs exist or cannot be resumed
  /// @throws RunError  if the trajectory blows up, or a file cannot be written
  RunResult run(const OutputOptions& options = {}, const Callbacks& callbacks = {});
  /// The step of the last checkpoint, from which a run can be resumed. The step is set if run()
  /// threw an error, for example because the disk was full.
  std::optional<std::size_t> resumable_step() const { return resumable_step_; }

 private:
  void set_guarantee(const Guarantee& guarantee);
  bool choose_step(const OutputOptions& options, const Callbacks& callbacks);
  const std::string& identity();
  std::optional<FoundCheckpoint> find_checkpoint(const RunFileNames& names,
                                                 const OutputOptions& options,
                                                 const Callbacks& callbacks);
  void check_length(std::size_t steps_done, const Segment& segment) const;
  RunState run_state();
  void resume(Checkpoint checkpoint);
  RunState next_segment(const std::string& changes);
  std::string command_of(const std::string& command) const;
  void note_begin(const Callbacks& callbacks) const;
  void note_warnings(const Callbacks& callbacks) const;
  bool minimise(const Callbacks& callbacks, RunFiles* files);
  bool equilibrate(const Callbacks& callbacks, RunFiles* files);
  bool trajectory_started() const;
  const TrajectorySettings& settings() const;
  Propagator& propagator();
  Trajectory run_trajectory(RunFiles& files, const Callbacks& callbacks);
  RunSummary summary_of(const Trajectory& trajectory) const;
  RunReport report(const Trajectory& trajectory, const RunFileNames& names,
                   const Callbacks& callbacks) const;
  ExecutionSettings execution() const;

  Config config_;
  Workers& workers_;
  std::optional<TrajectorySettings> settings_;  // empty until the step is chosen
  std::optional<Guarantee> guarantee_;
  System system_;
  ForceField forces_;
  std::string identity_;
  bool settings_changed_ = false;               // since the system was built
  ForceNoise noise_;                            // at the start of the trajectory
  std::uint64_t minimisation_evaluations_ = 0;  // number of force evaluations
  std::optional<RunState> at_;                  // current state, until the propagator is created
  std::optional<Propagator> propagator_;
  std::optional<std::size_t> resumable_step_;
};

}  // namespace polhode
