// SPDX-License-Identifier: MIT
// polhode advise [FILE]: finds the cheapest scheme and step that meet an accuracy.
#include <fmt/core.h>

#include <memory>
#include <string>
#include <vector>

#include "advise_report.hpp"
#include "console.hpp"
#include "criterion_options.hpp"
#include "hybrid_advice_report.hpp"
#include "job_options.hpp"
#include "option_values.hpp"
#include "polhode/base/error.hpp"
#include "streams.hpp"
#include "verbs.hpp"

namespace polhode::cli {
namespace {

struct Options : JobOptions {
  CriterionOptions criterion;
  std::string ensemble, length, output = "advice";
  int evaluations = static_cast<int>(HybridAdviserSettings{}.evaluations);
  std::vector<std::string> schemes;
  double seconds = AdviserSettings{}.seconds;
  bool force = false;
};

Config make_config(const Options& o) {
  Config config = o.config();
  set_time(config.run.length, o.length, "--length");
  set_schemes(config.integrator.candidates, o.schemes, "--schemes", config.schemes);
  return config;
}

/// For the canonical ensemble: hybrid Monte Carlo, which has no bias to bound.
int advise_canonical(const Options& o, const Config& config) {
  HybridAdviserSettings settings;
  settings.evaluations = static_cast<std::size_t>(o.evaluations);
  if (!o.schemes.empty()) settings.scheme = config.integrator.candidates.front();
  if (o.schemes.size() > 1)
    throw Error("--schemes names several schemes; hybrid Monte Carlo is advised for one at a time");
  Workers workers = o.workers();
  const HybridAdvice advice = advise_hybrid(config, settings, console(), workers);
  if (advice.stopped) {
    log("interrupted before the search ended\n");
    return 130;
  }
  if (o.json)
    fmt::print("{}\n", hybrid_advice_json(advice));
  else
    print_hybrid_advice(advice);
  if (advice.finalists.empty()) throw RunError(answer(advice));
  return 0;
}

int advise(const Options& o) {
  const Config config = make_config(o);
  if (!o.ensemble.empty() &&
      named_option<StudyEnsemble>(o.ensemble, "--ensemble") == StudyEnsemble::nvt)
    return advise_canonical(o, config);
  const AdviserSettings settings{criterion_option(o.criterion, config.integrator),
                                 config.integrator.candidates, o.seconds};
  Workers workers = o.workers();
  const OutputOptions output{existing_files(false, o.force),
                             o.command({"--accuracy", "--drift", "--temperature-bias"})};
  const AdviceReport report = run_adviser(config, settings, o.output, output, console(), workers);
  if (report.advice.stopped) {
    log("interrupted before the search ended; no file was written\n");
    return 130;
  }
  if (o.json)
    fmt::print("{}\n", advice_json(report));
  else
    print_advice(report);
  if (!report.advice.best) throw RunError(unreachable(report.advice, settings.criterion));
  return 0;
}

}  // namespace

Action advise_verb(Command& command) {
  auto o = std::make_shared<Options>();
  o->declare(command, "simultaneous runs");
  o->declare_precision(command);
  o->criterion.declare(command);
  command.add_option("--ensemble", o->ensemble,
                     "nvt: step and trajectory length of hybrid Monte Carlo; default: nve");
  command
      .add_option("--evaluations", o->evaluations,
                  "with --ensemble nvt: force evaluations of each pilot run")
      .in_range(100, 100'000'000)
      .show_default();
  command.add_option("--schemes", o->schemes,
                     "names, or stages as text, instead of the run file's candidates");
  command.add_option("--length", o->length,
                     "length of the runs to be planned; default: the run file's");
  command.add_option("--time", o->seconds, "approximate computing time, in seconds")
      .in_range(0.1, 1e6)
      .show_default();
  command.add_option("--output", o->output, "prefix of the output files").show_default();
  command.add_flag("--force", o->force, "overwrite output files that exist");
  return [o] { return advise(*o); };
}

}  // namespace polhode::cli
