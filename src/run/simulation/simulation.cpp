// SPDX-License-Identifier: MIT
#include "polhode/run/simulation/simulation.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "base/output_error.hpp"
#include "base/version.hpp"
#include "io/coordinates/gro.hpp"
#include "io/figures/plot.hpp"
#include "io/files/draft.hpp"
#include "io/files/with_error.hpp"
#include "io/files/write_file.hpp"
#include "io/settings/output_units.hpp"
#include "polhode/io/settings/nested_scheme_text.hpp"
#include "run/output_files.hpp"
#include "run/simulation/files/run_files.hpp"
#include "run/simulation/report/warning_rules.hpp"
#include "run/simulation/system/near_forces.hpp"
#include "run/simulation/system/relaxation.hpp"
#include "run/simulation/system/system_notes.hpp"

namespace polhode {
namespace {

/// R as text, in the form of the summary. The text is empty if R is not defined or not meaningful.
/// R is not meaningful for hybrid Monte Carlo, whose decisions change the energy without a
/// time-step error.
std::string ratio_text(const RunSummary& s) {
  if (s.samples < min_samples_reported || s.potential_fluctuation.value == 0 ||
      s.ensemble.hybrid_monte_carlo)
    return {};
  const bool known = s.ratio.known == Known::yes;
  return with_error(100 * s.ratio.value, known ? 100 * s.ratio.error : std::nan("")) + " %";
}

EnergyFigure energy_figure(const RunSummary& summary, const std::string& csv,
                           const std::string& title) {
  return {csv, title, summary.ensemble.hybrid_monte_carlo ? "total" : "conserved",
          ratio_text(summary)};
}

}  // namespace

Simulation::Simulation(const Config& config, Workers& workers)
    : config_(config),
      workers_(workers),
      settings_(config.integrator.accuracy ? std::nullopt
                                           : std::optional(trajectory_settings(config))),
      system_(build_system(config)),
      forces_(system_.topology, system_.forces, system_.state.box, workers) {
  if (settings_) check_near(system_.forces, {settings_->scheme, settings_->inner}, config.source);
}

std::size_t Simulation::steps() const {
  return propagator_ ? propagator_->steps() : at_ ? at_->steps : 0;
}

Energies Simulation::energies() const {
  ForceField forces(system_.topology, system_.forces, system_.state.box, workers_);
  Load load;
  forces(system_.state, load);
  Energies now = energies_of(system_, system_.state, load, workers_);
  now.exchanged = propagator_ ? propagator_->exchanged() : at_ ? at_->ensemble.exchanged() : 0;
  return now;
}

RunSummary Simulation::summary_of(const Trajectory& trajectory) const {
  RunSummary summary = polhode::summary(system_, *settings_, trajectory, noise_);
  summary.minimisation_evaluations = minimisation_evaluations_;
  return summary;
}

RunSummary Simulation::summary() {
  if (!trajectory_started())
    throw Error("there is no trajectory yet; first advance by at least one step");
  return summary_of(propagator().trajectory());
}

RunReport Simulation::report() {
  RunReport report{summary(), *settings_, execution(), RunFileNames(config_.output), {}, {}};
  report.warnings = warnings(report.summary, system_, *settings_, config_, workers_);
  return report;
}

// Accuracy.

void Simulation::set_guarantee(const Guarantee& guarantee) {
  guarantee_ = guarantee;
  settings_ = trajectory_settings(config_, guarantee.length);
  check_near(system_.forces, {settings_->scheme, settings_->inner}, config_.source);
}

bool Simulation::choose_step(const Callbacks& callbacks) {
  if (!config_.integrator.accuracy || guarantee_) return true;
  const auto chosen = choose_guaranteed_step(config_, callbacks, workers_);
  if (chosen) set_guarantee(*chosen);
  return chosen.has_value();
}

bool Simulation::choose_step(const OutputOptions& options, const Callbacks& callbacks) {
  if (!config_.integrator.accuracy) return true;
  const std::string file = config_.output.prefix + "-guarantee.json";
  if (options.existing == ExistingFiles::resume && std::filesystem::exists(file)) {
    if (!guarantee_) set_guarantee(read_guarantee(file, config_));
    return true;
  }
  check_outputs({file}, options.existing);
  if (!choose_step(callbacks)) return false;
  write_guarantee(file, *guarantee_, config_.integrator);
  return true;
}

// Checkpoints.

// Call this function before the state changes. After a change of settings, the function may be
// called later, because it builds the system again. A new simulation with the present settings can
// resume from the checkpoints of this simulation.
const std::string& Simulation::identity() {
  if (identity_.empty())
    identity_ = run_identity(config_, settings_changed_ ? build_system(config_) : system_);
  return identity_;
}

// Before the first step, the run state is the same as after an equilibration of length zero.
RunState Simulation::run_state() {
  if (trajectory_started()) return propagator().run_state();
  return at_ ? *at_ : RunState{.state = system_.state, .equilibrated = 0.0};
}

void Simulation::save(const std::string& path, const std::string& command) {
  write_checkpoint({path, ""}, {.identity = identity(),
                                .command = command_of(command),
                                .at = run_state(),
                                .noise = noise_,
                                .minimisation_evaluations = minimisation_evaluations_});
}

void Simulation::resume(const std::string& path) { resume(read_checkpoint_of(path, identity())); }

void Simulation::resume(Checkpoint checkpoint) {
  noise_ = checkpoint.noise;
  minimisation_evaluations_ = checkpoint.minimisation_evaluations;
  at_ = std::move(checkpoint.at);
  system_.state = at_->state;
  propagator_.reset();
}

void Simulation::check_length(std::size_t steps_done, const Segment& segment) const {
  if (steps_done > last_step(*settings_, segment))
    throw Error(
        fmt::format("the length of {:g} ps is shorter than the {:g} ps that are already simulated; "
                    "give a longer length",
                    settings_->length, simulated(*settings_, segment, steps_done)));
}

// Finds the checkpoint from which to resume, if resuming is requested and a checkpoint exists.
// Existing files of another run are rejected.
std::optional<FoundCheckpoint> Simulation::find_checkpoint(const RunFileNames& names,
                                                           const OutputOptions& options,
                                                           const Callbacks& callbacks) {
  std::optional<FoundCheckpoint> found;
  const bool resumes = options.existing == ExistingFiles::resume;
  if (resumes) found = last_checkpoint(names.checkpoints, identity());
  if (!found) {
    if (resumes) callbacks.note("note: there is no checkpoint; the run starts from the beginning");
    if (options.existing != ExistingFiles::replace &&
        std::filesystem::exists(names.checkpoints.newest))
      throw OutputError(
          fmt::format("'{}' exists: the run was started before; resume it, give another output, or "
                      "start over",
                      names.checkpoints.newest),
          true);
    // The final state may replace the initial configuration, which the run no longer needs then.
    check_outputs(names.all(), options.existing);
    return found;
  }
  if (!found->note.empty()) callbacks.note("note: " + found->note);
  const RunState& at = found->checkpoint.at;
  check_length(at.steps, at.segment);
  callbacks.note(at.equilibrated
                     ? fmt::format("resuming after {:g} ps of the equilibration", *at.equilibrated)
                     : fmt::format("resuming after {} steps, {:g} ps", at.steps,
                                   simulated(*settings_, at.segment, at.steps)));
  return found;
}

// Trajectory.

bool Simulation::trajectory_started() const {
  return propagator_.has_value() || (at_ && !at_->equilibrated);
}

bool Simulation::equilibrate(const Callbacks& callbacks) { return equilibrate(callbacks, nullptr); }

// For an interrupted minimisation the checkpoint contains the initial configuration, so the
// minimisation starts over.
bool Simulation::minimise(const Callbacks& callbacks, RunFiles* files) {
  if (!config_.run.minimise || (at_ && *at_->equilibrated > 0)) return true;
  const RunState start = run_state();
  const Minimisation result = polhode::minimise(system_, {}, watch_of(callbacks), workers_);
  if (result.end != MinimisationEnd::stopped) {
    callbacks.note(description(result));
    check_separated(system_, result);
    minimisation_evaluations_ = result.evaluations();
    if (files) files->keep(minimisation_evaluations_);
    return true;
  }
  system_.state = start.state;
  at_ = start;
  if (files) files->checkpoint(start);
  return false;
}

bool Simulation::equilibrate(const Callbacks& callbacks, RunFiles* files) {
  if (trajectory_started()) return true;
  identity();
  if (at_)
    system_.state = at_->state;
  else
    check_lattice(system_, config_);
  const RunState start = run_state();
  if (!minimise(callbacks, files)) return false;
  RunState from = start;
  from.state = system_.state;
  const double length = config_.run.equilibrate;
  double now = 0;
  Watch watch{.sample =
                  [&](std::size_t, const State& state, const Energies&) {
                    now = std::max(now, state.time);
                    callbacks.report({"equilibrating", now / length});
                  },
              .stop = callbacks.stop,
              .checkpoint =
                  [&](RunState at) {
                    if (*at.equilibrated == 0) at = start;
                    at_ = at;
                    if (files) files->checkpoint(std::move(at));
                  }};
  if (files) watch.due = [files] { return files->due(); };
  if (length > 0 &&
      !polhode::equilibrate(system_, forces_, length, watch, workers_, at_ ? &from : nullptr))
    return false;
  at_.reset();
  noise_ = force_noise(system_, workers_);
  propagator();
  return true;
}

const TrajectorySettings& Simulation::settings() const {
  if (!settings_)
    throw Error(fmt::format("the run requires accuracy = \"{}\", but its step has not been chosen "
                            "yet; choose the step first, or give a step instead of an accuracy",
                            text_of(*config_.integrator.accuracy)),
                config_.source);
  return *settings_;
}

Propagator& Simulation::propagator() {
  identity();
  if (!propagator_) {
    propagator_.emplace(system_, forces_, settings(), workers_);
    if (at_) propagator_->resume_from(*std::exchange(at_, std::nullopt));
  }
  return *propagator_;
}

std::size_t Simulation::steps_in(double time) const { return settings().steps_in(time); }

std::size_t Simulation::steps_left() const {
  const std::size_t last = last_step(settings(), segment());
  return last - std::min(last, steps());
}

bool Simulation::step(std::size_t steps, const Callbacks& callbacks) {
  if (settings_ && !equilibrate(callbacks)) return false;
  Propagator& trajectory = propagator();
  const std::size_t first = trajectory.steps();
  const Watch watch{.sample =
                        [&](std::size_t step, const State& state, const Energies& energies) {
                          callbacks.report({"running", static_cast<double>(step - first) /
                                                           static_cast<double>(steps)});
                          if (callbacks.sample) callbacks.sample(step, state, energies);
                        },
                    .stop = callbacks.stop};
  trajectory.advance(steps, watch);
  return trajectory.steps() - first == steps;
}

Trajectory Simulation::run_trajectory(RunFiles& files, const Callbacks& callbacks) try {
  const auto last = static_cast<double>(last_step(*settings_, segment()));
  const Watch watch{.sample =
                        [&](std::size_t step, const State& state, const Energies& energies) {
                          callbacks.report({"running", static_cast<double>(step) / last});
                          if (callbacks.sample) callbacks.sample(step, state, energies);
                          files.sample(step, state, energies);
                        },
                    .stop = callbacks.stop,
                    .due = [&] { return files.due(); },
                    .checkpoint = [&](RunState at) { files.checkpoint(std::move(at)); },
                    .load = [&](const State& state,
                                const Load& load) { files.load(state, system_.bodies, load); }};
  if (steps() > 0 && !files.last_checkpoint_step())  // outputs begin within the trajectory
    files.checkpoint(propagator().run_state());
  Trajectory trajectory = propagator().run(watch);
  files.flush();
  return trajectory;
} catch (const RunError&) {
  resumable_step_ = files.last_checkpoint_step();
  throw;
}

// A run with its files.

ExecutionSettings Simulation::execution() const {
  return {workers_.threads(), this_program().instruction_set};
}

void Simulation::note_begin(const Callbacks& callbacks) const {
  const ExecutionSettings with = execution();
  callbacks.note(fmt::format(
      "polhode {}: {} molecules, {}, {} in {:g} fs steps, instruction set {}, threads {}",
      version(), system_.topology.size(), config_.source,
      name_of({settings_->scheme, settings_->inner}), settings_->step * units::fs_per_ps,
      with.instruction_set, with.threads));
  note_ensemble(*settings_, callbacks);
  note_molecules(system_, callbacks);
  note_velocities(system_, config_, callbacks);
  note_forces(system_, callbacks);
}

// A run from a lattice gets no warning about the step, because forces on a lattice do not show
// which steps are stable.
void Simulation::note_warnings(const Callbacks& callbacks) const {
  const bool lattice = config_.system.initial_configuration.empty() && config_.run.equilibrate == 0;
  for (const auto& warning :
       {cutoff_of_ions(system_), velocities_of_file(system_, config_),
        rough_truncation(system_, *settings_),
        lattice ? std::nullopt : step_near_stability(system_, *settings_, workers_)})
    if (warning) callbacks.note(line_of(*warning));
}

RunResult Simulation::run(const OutputOptions& options, const Callbacks& callbacks) {
  resumable_step_.reset();
  const RunFileNames names(config_.output);
  check_prefix(config_.output.prefix, names.all());
  const OutputLock lock(config_.output.prefix + "-run.lock", callbacks);
  if (!choose_step(options, callbacks)) return {RunEnd::interrupted_choosing_step, {}};
  for (const std::string& file : names.trajectories)
    check_fit(file, system_.state, system_.topology, config_.output.choice());
  check_length(steps(), segment());
  auto found = find_checkpoint(names, options, callbacks);
  remove_drafts(names.all());
  RunFiles files(names, system_.topology, config_,
                 provenance(command_of(options.command), config_.text, config_.system.seed),
                 identity(), found ? &*found : nullptr);
  if (found) resume(std::move(found->checkpoint));
  files.keep(minimisation_evaluations_);
  note_begin(callbacks);

  if (!equilibrate(callbacks, &files)) return {RunEnd::interrupted_equilibrating, {}};
  files.keep(noise_);
  note_warnings(callbacks);
  const Trajectory trajectory = run_trajectory(files, callbacks);
  if (!trajectory.failure.empty()) {
    if (trajectory.statistics.energies.samples > 0)
      callbacks.note(fmt::format("the energies before the blow-up are in {}", names.energies));
    throw RunError(trajectory.failure);
  }
  return {trajectory.stopped ? RunEnd::interrupted : RunEnd::complete,
          report(trajectory, names, callbacks)};
}

RunReport Simulation::report(const Trajectory& trajectory, const RunFileNames& names,
                             const Callbacks& callbacks) const {
  write_file(names.final_state,
             [&](std::ostream& out) { write_gro(out, system_.state, system_.topology); });
  RunReport report{summary_of(trajectory), *settings_, execution(), names, {}, {},
                   trajectory.stopped};
  if (!names.plot.empty())
    pass_messages(callbacks, [&](std::ostream& warnings) {
      draw_figure(energy_figure(report.summary, names.energies,
                                fmt::format("{}, {} at {:g} fs", config_.source,
                                            name_of({settings_->scheme, settings_->inner}),
                                            settings_->step * units::fs_per_ps)),
                  config_.output.plot, warnings);
    });
  report.warnings = warnings(report.summary, system_, *settings_, config_, workers_);
  if (guarantee_ && !trajectory.stopped)
    report.guarantee = check_guarantee(*guarantee_, trajectory.statistics, report.summary);
  return report;
}

}  // namespace polhode
