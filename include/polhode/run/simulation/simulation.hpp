// SPDX-License-Identifier: MIT
// A simulation of a run file: in memory, step by step, or as a whole with its files.
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

/// How Simulation::run() ended. An interrupted equilibration or trajectory resumes from a
/// checkpoint. An interrupted choice of the step has no file and starts over.
enum class RunEnd {
  complete,
  interrupted,                ///< interrupted in the trajectory
  interrupted_equilibrating,  ///< interrupted before the trajectory
  interrupted_choosing_step   ///< interrupted before the equilibration
};

struct RunResult {
  RunEnd end;
  std::optional<RunReport> report;  ///< report of the trajectory, if it started
};

/// The system of a run file and its trajectory: an equilibration, if the run file has one, and
/// steps of its scheme. The trajectory has the same bits whether it is computed by step(), by
/// run(), or resumed, and with any number of threads.
class Simulation {
 public:
  /// Builds the system; nothing is computed and no file is written.
  /// @param workers  kept by reference
  /// @throws Error  with its place, if a setting or the initial configuration does not fit
  explicit Simulation(const Config& config, Workers& workers = Workers::serial());
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// The run file's settings, with scheme and step as chosen by choose_step().
  const Config& config() const { return config_; }
  const System& system() const { return system_; }
  const State& state() const { return system_.state; }
  /// The state, for changes between two steps. Call state_changed() after a change. Its memory
  /// stays in place until the end of the simulation.
  State& state_to_change();
  /// Begins a segment of the trajectory with the state as it is now and new forces.
  /// @throws Error  if the state is not one of these molecules, with nothing changed but
  /// orientations,
  ///                which are normalized
  void state_changed();
  /// Continues with another scheme or step, or in another ensemble, in a new segment of the
  /// trajectory. Momenta are not changed. If an accuracy is required, a new step is chosen.
  /// @throws Error  with nothing changed, if they do not suit each other or the forces, or if they
  ///                add, remove or change hybrid Monte Carlo
  void change(const IntegratorSettings& integrator, const EnsembleSettings& ensemble);
  /// Steps of the trajectory done so far.
  std::size_t steps() const;
  /// The part of the trajectory with the present settings.
  Segment segment() const;
  /// The numbers of steps that run() and a run of a given time [ps] take: see TrajectorySettings.
  std::size_t steps_left() const;
  std::size_t steps_in(double time) const;
  /// Energies of the current state, with the heat and work received so far, from a separate force
  /// evaluation that leaves the trajectory as it is.
  Energies energies() const;
  /// Statistics of the trajectory's present segment so far.
  RunSummary summary();
  /// Report of a trajectory in memory, with warnings, as from run().
  RunReport report();

  /// If the run file asks for an accuracy, lets the adviser choose the step, and the scheme unless
  /// the run file has one. run() calls it.
  /// @return  false if it was interrupted
  /// @throws RunError  if no scheme meets the accuracy
  bool choose_step(const Callbacks& callbacks = {});
  /// Minimises and equilibrates as the run file asks, once. step() and run() call it.
  /// @return  false if it was interrupted; another call resumes it
  /// @throws RunError  if it blows up
  bool equilibrate(const Callbacks& callbacks = {});
  /// Advances the trajectory in memory.
  /// @return  false if it was interrupted, in the equilibration or between two steps
  /// @throws Error     if the run file asks for an accuracy whose step is not chosen yet
  /// @throws RunError  if it blows up
  bool step(std::size_t steps = 1, const Callbacks& callbacks = {});

  /// Writes a checkpoint of the simulation.
  /// @param command  by which it is made, for the record
  /// @throws RunError  if the file cannot be written
  void save(const std::string& path, const std::string& command = "Simulation::save");
  /// Resumes a checkpoint of the same run, written by save() or by run(), by the same version of
  /// the program with the same instruction set.
  /// @throws Error  if it is damaged, or of another run or program
  void resume(const std::string& path);

  /// Continues to the length of the run file and writes all of its outputs: energies, trajectories,
  /// checkpoints, the final state, a figure. [output] gives files and names; a lock keeps other
  /// processes from using them.
  /// @throws Error     before anything is computed, if outputs exist or cannot be resumed
  /// @throws RunError  if the trajectory blows up, or a file cannot be written
  RunResult run(const OutputOptions& options = {}, const Callbacks& callbacks = {});
  /// The step of the last checkpoint if run() threw an error that does not keep the run from being
  /// resumed there, such as a full disk.
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
  std::optional<TrajectorySettings> settings_;  // none until the step is chosen
  std::optional<Guarantee> guarantee_;
  System system_;
  ForceField forces_;
  std::string identity_;
  bool settings_changed_ = false;               // since the system was built
  ForceNoise noise_;                            // of the forces at the start of the trajectory
  std::uint64_t minimisation_evaluations_ = 0;  // of forces
  std::optional<RunState> at_;  // its current state, until the propagator takes it over
  std::optional<Propagator> propagator_;
  std::optional<std::size_t> resumable_step_;
};

}  // namespace polhode
