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

/// @param stretch  over which R is found as well [ps]; 0: none
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
        fmt::format("length {:g} fs is shorter than the step of {:g} fs; ask for one step at least",
                    settings.length * 1000, settings.step * 1000),
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
    if (o.resume) log("note: there is no checkpoint yet; the run begins\n");
    if (!o.force && std::filesystem::exists(names.checkpoints.newest))
      throw Error(
          fmt::format("'{}' is there already: the run was begun before; go on with "
                      "--continue, name another output, or give --force to begin anew",
                      names.checkpoints.newest));
    for (const std::string& file : names.all()) refuse_existing(file, o.force);
    return found;
  }
  if (!found->note.empty()) log("note: {}\n", found->note);
  const RunState& at = found->checkpoint.at;
  if (at.steps > settings.steps())
    throw Error(
        fmt::format("length {:g} ps is shorter than the {:g} ps that are done already; ask "
                    "for as much or more",
                    settings.length, static_cast<double>(at.steps) * settings.step));
  if (at.equilibrated)
    log("going on after {:g} ps of the equilibration\n", *at.equilibrated);
  else
    log("going on after {} steps, {:g} ps\n", at.steps,
        static_cast<double>(at.steps) * settings.step);
  return found;
}

int run(const Options& o) {
  if (o.resume && o.force)
    throw Error(
        "--continue and --force contradict each other: one goes on with what is there, the other "
        "begins anew; give one of them");
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
  log("polhode {}: {} molecules, {}, {} in {:g} fs steps, target {}, threads {}\n", POLHODE_VERSION,
      system.topology.size(), config.source, name_of({settings.scheme, settings.inner}),
      settings.step * 1000, execution.instruction_set, execution.threads);
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
      log("interrupted while equilibrating; '{}' holds where it was, and --continue goes on\n",
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
      log("'{}' holds the run until step {}, and --continue goes on from there\n",
          names.checkpoints.newest, *files.last_checkpoint_step());
    throw;
  }
  if (t.statistics.energies.samples == 0) throw RunError(t.failure);
  if (!t.failure.empty()) {
    log("the energies until then are in {}\n", names.energies);
    throw RunError(t.failure);
  }
  if (t.stopped)
    log("interrupted after {} steps; what was computed follows, and --continue goes on\n", t.steps);

  const RunSummary s = summary(system, settings, t, noise);
  write_file(names.final_state,
             [&](std::ostream& out) { write_gro(out, system.state, system.topology); });
  if (!names.plot.empty())
    energy_plot(names.energies,
                fmt::format("{}, {} at {:g} fs", config.source,
                            name_of({settings.scheme, settings.inner}), settings.step * 1000),
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
  app.add_option("FILE", o->file, "run file (TOML); without it: 512 TIP4P waters");
  app.add_option("--scheme", o->scheme, "instead of the run file's: a name, or stages as text");
  app.add_option("--step", o->step, "instead of the run file's: \"2 fs\"");
  app.add_option("--length", o->length, "instead of the run file's: \"15 ps\"");
  app.add_option("--output", o->output, "prefix of the output files, instead of the run file's");
  app.add_option("--precision", o->precision,
                 "of the pairs, instead of the run file's: double or mixed");
  app.add_option("--threads", o->threads,
                 "that share the work of a run; without it: one for each core allowed");
  app.add_flag("--continue", o->resume, "go on from the last checkpoint; begin if there is none");
  app.add_flag("--force", o->force, "overwrite output files that exist");
  app.add_flag("--json", o->json, "print the summary as JSON");
  return [o] { return run(*o); };
}

}  // namespace polhode::cli
