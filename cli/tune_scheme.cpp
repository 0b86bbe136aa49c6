// SPDX-License-Identifier: MIT
// polhode tune-scheme [FILE]: the best η for hoa2's family and η, ξ for gier4's, or the best free
// parameters of a scheme, for one system and step.
#include <fmt/core.h>

#include <memory>
#include <string>

#include "console.hpp"
#include "option_values.hpp"
#include "polhode/base/threads.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/run/study/tune.hpp"
#include "streams.hpp"
#include "verbs.hpp"

namespace polhode::cli {
namespace {

struct Options {
  std::string file, scheme, step, length, decorrelate, sample, threads;
  int runs = TuneSettings{}.runs;
  bool json = false;
};

TuneSettings make_settings(const Options& o) {
  TuneSettings settings;
  settings.scheme = o.scheme;
  if (!o.step.empty()) settings.step = positive_time(o.step, "--step");
  settings.runs = o.runs;
  if (!o.length.empty()) settings.length = positive_time(o.length, "--length");
  if (!o.decorrelate.empty()) settings.decorrelate = positive_time(o.decorrelate, "--decorrelate");
  if (!o.sample.empty()) settings.sample = positive_time(o.sample, "--sample");
  return settings;
}

void print(const Tuned& t) {
  const auto ratio = [](const Estimate& R) {
    return fmt::format("{:.4g} ± {:.2g}", 100 * R.value, 100 * R.error);
  };
  fmt::print("\nfamily of {}\n", t.reference);
  for (const TunedParameter& p : t.parameters)
    fmt::print("  {:<17} {:.5f} ± {:.2g}\n", p.name, p.value, p.error);
  fmt::print("  R                 {} %, {} for {}\n", ratio(t.ratio), ratio(t.reference_ratio),
             t.reference);
  fmt::print("  gain              {:.3f} ± {:.2g} measured, {:.3f} predicted\n", t.gain.value,
             t.gain.error, t.predicted_gain);
  fmt::print("  as text           \"{}\"\n", text_of(t.scheme));
}

int tune_scheme(const Options& o) {
  const TuneSettings settings = make_settings(o);
  Workers workers(requested_threads(o.threads, "--threads"));
  const TuneResult result = tune(read_config_option(o.file), settings, console(), workers);
  if (result.interrupted) {
    log("interrupted before a result was found\n");
    return 130;
  }
  if (o.json) {
    fmt::print("{}\n", tune_json(result));
    return 0;
  }
  const ErrorCovariance& c = result.covariance;
  fmt::print("error brackets, times h²: rms {:.4g} and {:.4g} kJ/mol, correlation {:.3f}\n",
             rms_bracket(c.aa, result.settings), rms_bracket(c.bb, result.settings),
             correlation(c));
  if (result.short_steps) fmt::print("eta of short steps: {:.5f}\n", *result.short_steps);
  for (const Tuned& family : result.families) print(family);
  return 0;
}

}  // namespace

Action tune_scheme_verb(CLI::App& app) {
  auto o = std::make_shared<Options>();
  app.add_option("FILE", o->file, "run file (TOML); default: 512 TIP4P waters");
  app.add_option("--scheme", o->scheme,
                 "stages with free parameters: \"free b = 0.2; B(b) A(1/2) ...\"; default: the run "
                 "file's if it has any, or else the families of hoa2 and gier4");
  app.add_option("--step", o->step, "time step to tune for: \"5 fs\"; default: the run file's");
  app.add_option("--runs", o->runs,
                 "number of runs for the measurement, and again for the confirmation")
      ->check(CLI::Range(2, 1000))
      ->capture_default_str();
  app.add_option("--length", o->length, "length of each run; default: \"2 ps\"");
  app.add_option("--decorrelate", o->decorrelate,
                 "equilibration of each initial configuration; default: \"2 ps\"");
  app.add_option("--sample", o->sample,
                 "time between samples of the error brackets; default: \"20 fs\"");
  app.add_option("--threads", o->threads,
                 "number of simultaneous runs; default: one for each available core");
  app.add_flag("--json", o->json, "print the results as JSON");
  return [o] { return tune_scheme(*o); };
}

}  // namespace polhode::cli
