// SPDX-License-Identifier: MIT
// polhode run [FILE]: a trajectory with its energies, plots and summary.
#include <fmt/core.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "guarantee.hpp"
#include "interrupt.hpp"
#include "option_values.hpp"
#include "polhode/base/error.hpp"
#include "polhode/base/instruction_set.hpp"
#include "polhode/base/threads.hpp"
#include "polhode/io/file_lock.hpp"
#include "polhode/io/gro.hpp"
#include "polhode/io/nested_scheme_text.hpp"
#include "polhode/io/output_units.hpp"
#include "polhode/io/plot.hpp"
#include "polhode/io/table_file.hpp"
#include "polhode/run/simulation/near_forces.hpp"
#include "polhode/run/simulation/run_files.hpp"
#include "polhode/run/simulation/summary.hpp"
#include "progress.hpp"
#include "run_report.hpp"
#include "streams.hpp"
#include "system_notes.hpp"
#include "verbs.hpp"

namespace polhode::cli {
namespace {

struct Options {
  std::string file, scheme, step, length, output, threads, precision;
  bool resume = false, force = false, json = false;
};

Config make_config(const Options& o) {
  Config config = o.file.empty() ? default_config() : read_config(o.file);
  if (!o.precision.empty()) set_precision(config, precision_option(o.precision));
  if (!o.scheme.empty()) {
    scheme_option(o.scheme, "--scheme");
    config.integrator.scheme = o.scheme;
    config.integrator.scheme_given = true;
  }
  if (!o.step.empty()) {
    config.integrator.step = positive_time(o.step, "--step");
    config.integrator.accuracy.reset();
  }
  if (!o.length.empty()) config.run.length = positive_time(o.length, "--length");
  if (!o.output.empty()) config.output.prefix = o.output;
  return config;
}

/// The command with those options that affect the results.
std::string command_line(const Options& o) {
  return typed_command("polhode run", {{"", o.file},
                                       {"--scheme", o.scheme},
                                       {"--step", o.step},
                                       {"--length", o.length},
                                       {"--output", o.output},
                                       {"--precision", o.precision}});
}

/// @param stretch  length of the stretches for which R is computed as well [ps]; 0: none
TrajectorySettings trajectory_settings(const Config& config, double stretch) {
  const NestedScheme scheme = nested_scheme_of(config.integrator.scheme);
  TrajectorySettings settings{.scheme = scheme.outer,
                              .step = config.integrator.step,
                              .length = config.run.length,
                              .sample = config.run.sample,
                              .lambda = config.integrator.lambda,
                              .inner = scheme.inner,
                              .configurational_sample = config.run.configurational_sample,
                              .seed = config.system.seed,
                              .stretch = stretch};
  if (settings.length < settings.step * (1 - 1e-9))
    throw Error(
        fmt::format(
            "length {:g} fs is shorter than the step of {:g} fs; it must be at least one step",
            settings.length * units::fs_per_ps, settings.step * units::fs_per_ps),
        config.source);
  try {
    settings.steps();
  } catch (const Error& e) {
    throw e.at(config.source);
  }
  constexpr double steps_per_shadow = 100;  // costs about 1 % of a run
  settings.shadow_sample = config.run.shadow_sample.value_or(
      settings.has_shadow() ? steps_per_shadow * settings.step : 0);
  settings.check_shadow();
  return settings;
}

/// The checkpoint to resume from, if requested and if there is one. Refuses to overwrite existing
/// files.
std::optional<FoundCheckpoint> find_resumable_checkpoint(const Options& o,
                                                         const RunFileNames& names,
                                                         const TrajectorySettings& settings,
                                                         const std::string& identity,
                                                         const ProgramVersion& program) {
  std::optional<FoundCheckpoint> found;
  if (o.resume) found = last_checkpoint(names.checkpoints, identity, program);
  if (!found) {
    if (o.resume) log("note: there is no checkpoint; the run starts from the beginning\n");
    if (!o.force && std::filesystem::exists(names.checkpoints.newest))
      throw Error(
          fmt::format("'{}' exists: the run was started before; resume it with --continue, give "
                      "another --output, or start over with --force",
                      names.checkpoints.newest));
    for (const std::string& file : names.all()) refuse_existing(file, o.force);
    return found;
  }
  if (!found->note.empty()) log("note: {}\n", found->note);
  const RunState& at = found->checkpoint.at;
  if (at.steps > settings.steps())
    throw Error(fmt::format(
        "length {:g} ps is shorter than the {:g} ps that the run already has; give a longer one",
        settings.length, static_cast<double>(at.steps) * settings.step));
  if (at.equilibrated)
    log("resuming after {:g} ps of the equilibration\n", *at.equilibrated);
  else
    log("resuming after {} steps, {:g} ps\n", at.steps,
        static_cast<double>(at.steps) * settings.step);
  return found;
}

int run(const Options& o) {
  if (o.resume && o.force)
    throw Error(
        "--continue and --force contradict each other: one resumes the existing run, the other "
        "starts over; give one of them");
  Config config = make_config(o);
  const FileLock lock(config.output.prefix + "-run.lock");
  note_lock(lock);
  Workers workers(requested_threads(o.threads));
  const auto guarantee = choose_guaranteed_step(config, {o.resume, o.force}, workers);
  if (interrupted()) return 130;
  const TrajectorySettings settings =
      trajectory_settings(config, guarantee ? guarantee->length : 0);
  System system = build_system(config);
  check_near(system.forces, {settings.scheme, settings.inner}, config.source);
  const RunFileNames names(config.output);
  for (const std::string& file : names.trajectories)
    check_fit(file, system.state, system.topology, config.output.choice());
  ForceField forces(system.topology, system.forces, system.state.box, workers);
  const Provenance provenance{POLHODE_VERSION, command_line(o), config.text,
                              name(current_instruction_set()), config.system.seed};
  const std::string identity = run_identity(config, system);
  const auto found = find_resumable_checkpoint(o, names, settings, identity,
                                               {provenance.version, provenance.instruction_set});
  const RunState* const from = found ? &found->checkpoint.at : nullptr;
  RunFiles files(names, system.topology, config, provenance, identity, found ? &*found : nullptr);

  const ExecutionSettings execution{workers.threads(), provenance.instruction_set};
  log("polhode {}: {} molecules, {}, {} in {:g} fs steps, instruction set {}, threads {}\n",
      POLHODE_VERSION, system.topology.size(), config.source,
      name_of({settings.scheme, settings.inner}), settings.step * units::fs_per_ps,
      execution.instruction_set, execution.threads);
  note_molecules(system);
  note_forces(system);

  catch_interrupts();
  const auto due = [&] { return files.due(); };
  const auto checkpoint = [&](RunState at) { files.checkpoint(std::move(at)); };
  const bool equilibrating = !from || from->equilibrated;
  if (equilibrating && config.run.equilibrate > 0) {
    Progress progress("equilibrating");
    double now = 0;
    const Watch watch{[&](std::size_t, const State& state, const Energies&) {
                        now = std::max(now, state.time);
                        progress.show(now / config.run.equilibrate);
                      },
                      interrupted, due, checkpoint};
    if (!equilibrate(system, forces, config.run.equilibrate, watch, workers, from)) {
      log("interrupted during the equilibration; '{}' is its checkpoint, and --continue resumes\n",
          names.checkpoints.newest);
      return 130;
    }
  }

  const ForceNoise noise = equilibrating ? force_noise(system, workers) : found->checkpoint.noise;
  files.keep(noise);
  Trajectory t;
  try {
    Progress progress("running");
    const Watch watch{
        [&](std::size_t step, const State& state, const Energies& energies) {
          progress.show(static_cast<double>(step) / static_cast<double>(settings.steps()));
          files.sample(step, state, energies);
        },
        interrupted, due, checkpoint};
    t = run_trajectory(system, forces, settings, watch, workers, equilibrating ? nullptr : from);
    files.flush();
  } catch (const RunError&) {
    if (files.last_checkpoint_step())
      log("'{}' is the checkpoint of step {}, from which --continue resumes\n",
          names.checkpoints.newest, *files.last_checkpoint_step());
    throw;
  }
  if (t.statistics.energies.samples == 0) throw RunError(t.failure);
  if (!t.failure.empty()) {
    log("the energies up to that step are in {}\n", names.energies);
    throw RunError(t.failure);
  }
  if (t.stopped)
    log("interrupted after {} steps; the results so far follow, and --continue resumes\n", t.steps);

  const RunSummary s = summary(system, settings, t, noise);
  write_file(names.final_state,
             [&](std::ostream& out) { write_gro(out, system.state, system.topology); });
  if (!names.plot.empty())
    energy_plot(
        names.energies,
        fmt::format("{}, {} at {:g} fs", config.source, name_of({settings.scheme, settings.inner}),
                    settings.step * units::fs_per_ps),
        config.output.plot, std::cerr);

  std::optional<GuaranteeCheck> guarantee_check;
  if (guarantee && !t.stopped) guarantee_check = check_guarantee(*guarantee, t.statistics);
  if (o.json) {
    print_json(s, settings, execution, names, guarantee_check, t.stopped);
  } else {
    print_summary(s, settings, execution);
    if (guarantee_check) print_guarantee(*guarantee_check);
    fmt::print("files                ");
    for (const std::string& file : names.all()) fmt::print(" {}", file);
    fmt::print("\n");
  }
  return t.stopped ? 130 : 0;
}

}  // namespace

Action run_verb(CLI::App& app) {
  auto o = std::make_shared<Options>();
  app.add_option("FILE", o->file, "run file (TOML); default: 512 TIP4P waters");
  app.add_option("--scheme", o->scheme, "a name, or stages as text; default: the run file's");
  app.add_option("--step", o->step, "time step: \"2 fs\"; default: the run file's");
  app.add_option("--length", o->length, "length of the run: \"15 ps\"; default: the run file's");
  app.add_option("--output", o->output, "prefix of the output files; default: the run file's");
  app.add_option("--precision", o->precision,
                 "precision of pair interactions, double or mixed; default: the run file's");
  app.add_option("--threads", o->threads,
                 "number of threads; default: one for each available core");
  app.add_flag("--continue", o->resume, "resume from the last checkpoint; start if there is none");
  app.add_flag("--force", o->force, "overwrite output files that exist");
  app.add_flag("--json", o->json, "print the summary as JSON");
  return [o] { return run(*o); };
}

}  // namespace polhode::cli
