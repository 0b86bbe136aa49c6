// SPDX-License-Identifier: MIT
// polhode advise [FILE]: finds the cheapest scheme and step that meet an accuracy.
#include <fmt/core.h>

#include <memory>
#include <string>
#include <vector>

#include "../options/criterion_options.hpp"
#include "../options/job_options.hpp"
#include "../options/option_values.hpp"
#include "../reports/hybrid_advice.hpp"
#include "../reports/reports.hpp"
#include "../terminal/console.hpp"
#include "../terminal/streams.hpp"
#include "../verbs.hpp"
#include "polhode/base/error.hpp"
#include "run/adviser/advice_report.hpp"

namespace polhode::cli {
namespace {

struct Options : JobOptions {
  CriterionOptions criterion;
  HybridAdviceOptions hybrid;
  std::string length, output = "advice";
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

int advise(const Options& o) {
  const Config config = make_config(o);
  Workers workers = o.workers();
  if (o.hybrid.chosen())
    return advise_hybrid(
        o.hybrid, config,
        o.schemes.empty() ? std::vector<NamedScheme>{} : config.integrator.candidates, o.json,
        workers);
  const AdviserSettings settings{criterion_option(o.criterion, config),
                                 config.integrator.candidates, o.seconds};
  const OutputOptions output{existing_files(false, o.force),
                             o.command({"--accuracy", "--drift", "--temperature-bias", "--bias"})};
  const AdviceReport report = run_adviser(config, settings, o.output, output, console(), workers);
  if (report.advice.stopped) {
    log("interrupted before the search ended; no file was written\n");
    return 130;
  }
  print_results(quantities(report), o.json);
  if (!report.advice.best) throw RunError(unreachable(report.advice, settings.criterion));
  return 0;
}

}  // namespace

Action advise_verb(Command& command) {
  auto o = std::make_shared<Options>();
  o->declare(command, "simultaneous runs");
  o->declare_precision(command);
  o->criterion.declare(command);
  o->hybrid.declare(command);
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
