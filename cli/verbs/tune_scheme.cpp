// SPDX-License-Identifier: MIT
// polhode tune-scheme [FILE]: the best η for hoa2's family and η, ξ for gier4's, or the best free
// parameters of a scheme, for one system and step.
#include <fmt/core.h>

#include <memory>
#include <string>

#include "../options/job_options.hpp"
#include "../options/option_values.hpp"
#include "../reports/reports.hpp"
#include "../terminal/console.hpp"
#include "../terminal/streams.hpp"
#include "../verbs.hpp"
#include "polhode/run/study/tune.hpp"

namespace polhode::cli {
namespace {

struct Options : JobOptions {
  TuneSettings settings;
  std::string step, length, decorrelate, sample;
};

TuneSettings make_settings(const Options& o, const OwnSchemes& own) {
  TuneSettings settings = o.settings;
  if (!settings.scheme.empty())
    settings.scheme = scheme_option(settings.scheme, "--scheme", own).text;
  set_time(settings.step, o.step, "--step");
  set_time(settings.length, o.length, "--length");
  set_time(settings.decorrelate, o.decorrelate, "--decorrelate");
  set_time(settings.sample, o.sample, "--sample");
  return settings;
}

int tune_scheme(const Options& o) {
  const Config config = o.config();
  const TuneSettings settings = make_settings(o, config.schemes);
  Workers workers = o.workers();
  const TuneResult result = tune(config, settings, console(), workers);
  if (result.interrupted) {
    log("interrupted before a result was found\n");
    return 130;
  }
  print_results(quantities(result), o.json);
  return 0;
}

}  // namespace

Action tune_scheme_verb(Command& command) {
  auto o = std::make_shared<Options>();
  const TuneSettings& settings = o->settings;
  o->declare(command, "simultaneous runs");
  command.add_option(
      "--scheme", o->settings.scheme,
      "stages with free parameters: \"free b = 0.2; B(b) A(1/2) ...\"; default: the run "
      "file's if it has any, otherwise the families of hoa2 and gier4");
  command.add_option("--step", o->step, "time step to tune for: \"5 fs\"; default: the run file's");
  command
      .add_option("--runs", o->settings.runs,
                  "number of runs for the measurement, and again for the confirmation")
      .in_range(2, 1000)
      .show_default();
  const auto time = [&](const char* name, std::string& text, const char* meaning, double value) {
    command.add_option(name, text, fmt::format("{}; default: \"{}\"", meaning, time_text(value)));
  };
  time("--length", o->length, "length of each run", settings.length);
  time("--decorrelate", o->decorrelate, "equilibration of each initial configuration",
       settings.decorrelate);
  time("--sample", o->sample, "time between samples of the error brackets", settings.sample);
  return [o] { return tune_scheme(*o); };
}

}  // namespace polhode::cli
