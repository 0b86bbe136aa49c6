// SPDX-License-Identifier: MIT
// polhode prepare [FILE]: an equilibrated start from composition, temperature and pressure or
// density.
#include <memory>
#include <string>

#include "../options/job_options.hpp"
#include "../options/option_values.hpp"
#include "../reports/reports.hpp"
#include "../terminal/console.hpp"
#include "../terminal/streams.hpp"
#include "../verbs.hpp"
#include "io/settings/ensemble_names.hpp"
#include "polhode/run/prepare/preparation.hpp"

namespace polhode::cli {
namespace {

struct Options : JobOptions {
  std::string pressure, nvt, npt, output;
  bool resume = false, force = false;
};

Config make_config(const Options& o) {
  Config config = o.config();
  if (!o.pressure.empty()) {
    auto& barostat = config.ensemble.barostat;
    if (!barostat) barostat = default_barostat();
    barostat->pressure = quantity(o.pressure, Dimension::pressure, "--pressure");
  }
  if (!o.nvt.empty()) config.prepare.nvt = time_option(o.nvt, "--nvt");
  if (!o.npt.empty()) config.prepare.npt = time_option(o.npt, "--npt");
  if (!o.output.empty()) config.output.prefix = o.output;
  return config;
}

void note_interrupted(const PreparationReport& report) {
  if (report.checkpoint.empty())
    log("interrupted; no file was written, and the same command starts over\n");
  else
    log("interrupted; '{}' is the checkpoint, and --continue resumes\n", report.checkpoint);
}

int prepare(const Options& o) {
  const Config config = make_config(o);
  Workers workers = o.workers();
  const PreparationReport report =
      polhode::prepare(config,
                       {existing_files(o.resume, o.force),
                        o.command({"--pressure", "--nvt", "--npt", "--temperature", "--seed",
                                   "--output", "--precision"})},
                       console(), workers);
  if (!report.properties) note_interrupted(report);
  if (o.json)
    print_results(quantities(report), true);
  else
    print_preparation(report);
  return report.properties ? 0 : 130;
}

}  // namespace

Action prepare_verb(Command& command) {
  auto o = std::make_shared<Options>();
  o->declare(command, "threads");
  o->declare_precision(command);
  o->declare_initial_motion(command);
  command.add_option("--pressure", o->pressure,
                     "of the barostat: \"1 bar\"; default: that of [barostat]; without any, the "
                     "volume is constant");
  command.add_option("--nvt", o->nvt, "length of NVT: \"20 ps\"; default: the run file's");
  command.add_option("--npt", o->npt, "length of NPT: \"100 ps\"; default: the run file's");
  command.add_option("--output", o->output, "prefix of the output files; default: the run file's");
  command.add_flag("--continue", o->resume,
                   "resume from the last checkpoint; start if there is none");
  command.add_flag("--force", o->force, "overwrite output files that exist");
  return [o] { return prepare(*o); };
}

}  // namespace polhode::cli
