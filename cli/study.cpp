// SPDX-License-Identifier: MIT
// polhode study [FILE]: accuracy against cost for each scheme, the figure of the paper.
#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <string>

#include "console.hpp"
#include "option_values.hpp"
#include "polhode/base/threads.hpp"
#include "streams.hpp"
#include "study_report.hpp"
#include "verbs.hpp"

namespace polhode::cli {
namespace {

struct Options {
  std::string file, output = "study", length, decorrelate, temperature, seed, threads, precision,
                    configurational, from_record;
  std::vector<std::string> schemes, steps;
  int runs = 0;
  bool quick = false, force = false, json = false;
};

Config make_config(const Options& o) {
  Config config = read_config_option(o.file, o.precision);
  StudySettings& study = config.study;
  if (o.quick) study = quick(study);
  if (!o.schemes.empty()) study.schemes = o.schemes;
  for (const std::string& scheme : o.schemes) scheme_option(scheme, "--schemes");
  if (!o.steps.empty()) {
    study.steps.clear();
    for (const std::string& step : o.steps) study.steps.push_back(positive_time(step, "--steps"));
    std::sort(study.steps.begin(), study.steps.end());
  }
  if (o.runs != 0) study.runs = o.runs;
  if (!o.length.empty()) study.length = positive_time(o.length, "--length");
  if (!o.decorrelate.empty()) study.decorrelate = positive_time(o.decorrelate, "--decorrelate");
  set_initial_motion(config, o.temperature, o.seed);
  if (!o.configurational.empty())
    study.configurational_sample = positive_time(o.configurational, "--configurational-sample");
  return config;
}

int study(const Options& o) {
  Workers workers(requested_threads(o.threads, "--threads"));
  const Config config = make_config(o);
  const auto output = [&](bool resume) {
    return OutputOptions{existing_files(resume && !o.force, o.force),
                         typed_command("polhode study", {{"", o.file},
                                                         {"--temperature", o.temperature},
                                                         {"--seed", o.seed},
                                                         {"--from-record", o.from_record}})};
  };
  const StudyReport report =
      o.from_record.empty()
          ? run_study(config, o.output, output(true), console(), workers)
          : report_study_record(config, o.from_record, o.output, output(false), console());
  if (o.json)
    fmt::print("{}\n", study_json(report));
  else
    print_study(report);
  if (report.interrupted)
    log("interrupted{}; the same command resumes from {}\n",
        report.points.empty() ? " before the first run ended" : "", StudyFiles(o.output).runs);
  return report.interrupted ? 130 : 0;
}

}  // namespace

Action study_verb(CLI::App& app) {
  auto o = std::make_shared<Options>();
  app.add_option("FILE", o->file, "run file (TOML); default: 512 TIP4P waters");
  app.add_flag("--quick", o->quick, "a small version: one to three minutes on two cores");
  app.add_option("--schemes", o->schemes, "names, or stages as text");
  app.add_option("--steps", o->steps, "steps for every scheme: \"2 fs\" \"4 fs\"");
  app.add_option("--runs", o->runs, "independent runs at each point")->check(CLI::Range(2, 1000));
  app.add_option("--length", o->length, "of each run: \"15 ps\"");
  app.add_option("--decorrelate", o->decorrelate,
                 "equilibration of each initial configuration: \"10 ps\"");
  app.add_option("--temperature", o->temperature, "\"298 K\"; default: the run file's");
  app.add_option("--seed", o->seed, "of the initial configurations; default: the run file's");
  app.add_option(
      "--configurational-sample", o->configurational,
      "time between samples of the configurational temperature: \"20 fs\"; default: none");
  app.add_option("--from-record", o->from_record,
                 "make tables and figure from this record, of any version, without runs");
  app.add_option("--output", o->output, "prefix of the output files")->capture_default_str();
  app.add_option("--precision", o->precision,
                 "precision of pair interactions, double or mixed; default: the run file's");
  app.add_option("--threads", o->threads,
                 "number of simultaneous runs; default: one for each available core");
  app.add_flag("--force", o->force, "start over if results of another study exist");
  app.add_flag("--json", o->json, "print the results as JSON");
  return [o] { return study(*o); };
}

}  // namespace polhode::cli
