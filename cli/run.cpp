// SPDX-License-Identifier: MIT
// polhode run [FILE]: a trajectory with its energies, plots and summary.
#include <memory>
#include <string>

#include "console.hpp"
#include "option_values.hpp"
#include "polhode/base/threads.hpp"
#include "polhode/run/simulation/simulation.hpp"
#include "run_report.hpp"
#include "streams.hpp"
#include "verbs.hpp"

namespace polhode::cli {
namespace {

struct Options {
  std::string file, scheme, step, length, equilibrate, temperature, seed, output, threads,
      precision;
  bool resume = false, force = false, json = false;
};

Config make_config(const Options& o) {
  Config config = read_config_option(o.file, o.precision);
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
  if (!o.equilibrate.empty()) config.run.equilibrate = time_option(o.equilibrate, "--equilibrate");
  set_initial_motion(config, o.temperature, o.seed);
  if (!o.output.empty()) config.output.prefix = o.output;
  return config;
}

OutputOptions output_options(const Options& o) {
  // Only options that affect the results.
  return {existing_files(o.resume, o.force),
          typed_command("polhode run", {{"", o.file},
                                        {"--scheme", o.scheme},
                                        {"--step", o.step},
                                        {"--length", o.length},
                                        {"--equilibrate", o.equilibrate},
                                        {"--temperature", o.temperature},
                                        {"--seed", o.seed},
                                        {"--output", o.output},
                                        {"--precision", o.precision}})};
}

int run(const Options& o) {
  const OutputOptions output = output_options(o);
  Workers workers(requested_threads(o.threads, "--threads"));
  Simulation simulation(make_config(o), workers);
  try {
    return print_run(simulation.run(output, console()), simulation, o.json);
  } catch (const RunError&) {
    note_resumable(simulation);
    throw;
  }
}

}  // namespace

Action run_verb(CLI::App& app) {
  auto o = std::make_shared<Options>();
  app.add_option("FILE", o->file, "run file (TOML); default: 512 TIP4P waters");
  app.add_option("--scheme", o->scheme, "a name, or stages as text; default: the run file's");
  app.add_option("--step", o->step, "time step: \"2 fs\"; default: the run file's");
  app.add_option("--length", o->length, "length of the run: \"15 ps\"; default: the run file's");
  app.add_option("--equilibrate", o->equilibrate,
                 "time of velocity rescaling before the run: \"5 ps\"; default: the run file's");
  app.add_option(
      "--temperature", o->temperature,
      "for drawing velocities, and for equilibration: \"298 K\"; default: the run file's");
  app.add_option("--seed", o->seed, "of lattice and velocities; default: the run file's");
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
