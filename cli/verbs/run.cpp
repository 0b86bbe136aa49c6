// SPDX-License-Identifier: MIT
// polhode run [FILE]: a trajectory with its energies, plots and summary.
#include <memory>
#include <string>

#include "../options/ensemble_options.hpp"
#include "../options/job_options.hpp"
#include "../options/option_values.hpp"
#include "../reports/reports.hpp"
#include "../terminal/console.hpp"
#include "../terminal/streams.hpp"
#include "../verbs.hpp"
#include "polhode/run/simulation/simulation.hpp"

namespace polhode::cli {
namespace {

struct Options : JobOptions {
  EnsembleOptions ensemble;
  std::string scheme, step, length, equilibrate, output;
  bool resume = false, force = false;
};

Config make_config(const Options& o) {
  Config config = o.config([&](Config& read) {
    for (const std::string& note : o.ensemble.apply(read)) log("{}\n", note);
  });
  if (!o.scheme.empty()) {
    config.integrator.scheme = scheme_option(o.scheme, "--scheme", config.schemes);
    config.given["integrator.scheme"] = {o.scheme, "--scheme"};
  }
  if (!o.step.empty()) {
    config.integrator.step = positive_time(o.step, "--step");
    config.integrator.accuracy.reset();
  }
  set_time(config.run.length, o.length, "--length");
  if (!o.equilibrate.empty()) config.run.equilibrate = time_option(o.equilibrate, "--equilibrate");
  if (!o.output.empty()) config.output.prefix = o.output;
  return config;
}

int run(const Options& o) {
  const OutputOptions output{
      existing_files(o.resume, o.force),
      o.command({"--scheme", "--step", "--length", "--equilibrate", "--temperature", "--seed",
                 "--output", "--precision", "--thermostat", "--friction", "--time-constant",
                 "--barostat", "--pressure", "--hybrid-steps"})};
  Workers workers = o.workers();
  Simulation simulation(make_config(o), workers);
  try {
    return print_run(simulation.run(output, console()), simulation, o.json);
  } catch (const RunError&) {
    note_resumable(simulation);
    throw;
  }
}

}  // namespace

Action run_verb(Command& command) {
  auto o = std::make_shared<Options>();
  o->declare(command, "threads");
  o->declare_precision(command);
  command.add_option("--scheme", o->scheme, "a name, or stages as text; default: the run file's");
  command.add_option("--step", o->step, "time step: \"2 fs\"; default: the run file's");
  command.add_option("--length", o->length,
                     "length of the run: \"15 ps\"; default: the run file's");
  command.add_option(
      "--equilibrate", o->equilibrate,
      "time of velocity rescaling before the run: \"5 ps\"; default: the run file's");
  o->declare_initial_motion(command);
  o->ensemble.declare(command);
  command.add_option("--output", o->output, "prefix of the output files; default: the run file's");
  command.add_flag("--continue", o->resume,
                   "resume from the last checkpoint; start if there is none");
  command.add_flag("--force", o->force, "overwrite output files that exist");
  return [o] { return run(*o); };
}

}  // namespace polhode::cli
