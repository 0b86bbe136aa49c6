// SPDX-License-Identifier: MIT
// polhode study [FILE]: accuracy against cost for each scheme, the figure of the paper.
#include <memory>
#include <string>

#include "../options/job_options.hpp"
#include "../options/option_values.hpp"
#include "../reports/reports.hpp"
#include "../terminal/console.hpp"
#include "../verbs.hpp"
#include "run/canonical/canonical_report.hpp"

namespace polhode::cli {
namespace {

struct Options : JobOptions {
  std::string ensemble, output = "study", length, decorrelate, configurational, from_record;
  std::vector<std::string> schemes, steps;
  int runs = 0;
  bool quick = false, force = false;
};

Config make_config(const Options& o) {
  Config config = o.config();
  StudySettings& study = config.study;
  if (!o.ensemble.empty()) study.ensemble = named_option<StudyEnsemble>(o.ensemble, "--ensemble");
  if (o.quick) study = quick(study);
  set_schemes(study.schemes, o.schemes, "--schemes", config.schemes);
  if (!o.steps.empty()) study.steps = sorted_times(o.steps, "--steps");
  if (o.runs != 0) study.runs = o.runs;
  set_time(study.length, o.length, "--length");
  set_time(study.decorrelate, o.decorrelate, "--decorrelate");
  set_time(study.configurational_sample, o.configurational, "--configurational-sample");
  return config;
}

int perform(const Options& o) {
  const bool anew = o.force || !o.from_record.empty();
  const OutputOptions output{existing_files(!anew, o.force),
                             o.command({"--temperature", "--seed", "--from-record"})};
  Workers workers = o.workers();
  const Config config = make_config(o);
  const std::string record = StudyFiles(o.output).runs;
  const bool runs = o.from_record.empty();
  if (config.study.ensemble == StudyEnsemble::nvt)
    return finish_study(
        runs ? run_canonical_study(config, o.output, output, console(), workers)
             : report_canonical_record(config, o.from_record, o.output, output, console()),
        record, o.json);
  return finish_study(runs
                          ? run_study(config, o.output, output, console(), workers)
                          : report_study_record(config, o.from_record, o.output, output, console()),
                      record, o.json);
}

}  // namespace

Action study_verb(Command& command) {
  auto o = std::make_shared<Options>();
  o->declare(command, "simultaneous runs");
  o->declare_precision(command);
  command.add_option("--ensemble", o->ensemble,
                     "nve: R and energy drift; nvt: bias of canonical averages; default: the run "
                     "file's, else nve");
  command.add_flag("--quick", o->quick, "a small version: one to three minutes on two cores");
  command.add_option("--schemes", o->schemes, "names, or stages as text");
  command.add_option("--steps", o->steps, "steps for every scheme: \"2 fs\" \"4 fs\"");
  command.add_option("--runs", o->runs, "independent runs at each point").in_range(2, 1000);
  command.add_option("--length", o->length, "of each run: \"15 ps\"");
  command.add_option("--decorrelate", o->decorrelate,
                     "equilibration of each initial configuration: \"10 ps\"");
  o->declare_initial_motion(command);
  command.add_option(
      "--configurational-sample", o->configurational,
      "time between samples of the configurational temperature: \"20 fs\"; default: none");
  command.add_option(
      "--from-record", o->from_record,
      "make tables and figure from this record, written by any version, without new runs");
  command.add_option("--output", o->output, "prefix of the output files").show_default();
  command.add_flag("--force", o->force, "start over if results of another study exist");
  return [o] { return perform(*o); };
}

}  // namespace polhode::cli
