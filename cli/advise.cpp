// SPDX-License-Identifier: MIT
// polhode advise [FILE]: finds the cheapest scheme and step that meet an accuracy.
#include <fmt/core.h>

#include <memory>
#include <string>
#include <vector>

#include "advise_report.hpp"
#include "console.hpp"
#include "option_values.hpp"
#include "polhode/base/error.hpp"
#include "polhode/base/threads.hpp"
#include "streams.hpp"
#include "verbs.hpp"

namespace polhode::cli {
namespace {

struct Options {
  std::string file, accuracy, drift, temperature_bias, length, output = "advice", threads,
                                                               precision;
  std::vector<std::string> schemes;
  double seconds = 60;
  bool force = false, json = false;
};

double fraction_option(const std::string& text, const std::string& option) {
  const double value = quantity(text, Dimension::fraction, option);
  if (!(value > 0 && value < 1))
    throw Error(fmt::format("{} = \"{}\" must be above 0 % and below 100 %", option, text));
  return value;
}

Criterion criterion(const Options& o, const Config& config) {
  if (!o.drift.empty()) {
    const double drift = quantity(o.drift, Dimension::power, "--drift");
    if (!(drift > 0))
      throw Error(fmt::format("--drift = \"{}\" must be above 0 kJ/mol/ns", o.drift));
    return {Quality::drift, drift};
  }
  if (!o.temperature_bias.empty())
    return {Quality::temperature_bias, fraction_option(o.temperature_bias, "--temperature-bias")};
  if (!o.accuracy.empty()) return {Quality::ratio, fraction_option(o.accuracy, "--accuracy")};
  if (config.integrator.accuracy) return {Quality::ratio, *config.integrator.accuracy};
  throw Error(
      "no accuracy is requested; give --accuracy \"0.5 %\", --drift \"0.1 kJ/mol/ns\" or "
      "--temperature-bias \"0.5 %\"");
}

Config make_config(const Options& o) {
  Config config = read_config_option(o.file, o.precision);
  if (!o.length.empty()) config.run.length = positive_time(o.length, "--length");
  for (const std::string& scheme : o.schemes) scheme_option(scheme, "--schemes");
  if (!o.schemes.empty()) config.integrator.candidates = o.schemes;
  return config;
}

int advise(const Options& o) {
  const Config config = make_config(o);
  const AdviserSettings settings{criterion(o, config), config.integrator.candidates, o.seconds};
  Workers workers(requested_threads(o.threads, "--threads"));
  const OutputOptions output{
      existing_files(false, o.force),
      typed_command("polhode advise", {{"", o.file},
                                       {"--accuracy", o.accuracy},
                                       {"--drift", o.drift},
                                       {"--temperature-bias", o.temperature_bias}})};
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

Action advise_verb(CLI::App& app) {
  auto o = std::make_shared<Options>();
  app.add_option("FILE", o->file, "run file (TOML); default: 512 TIP4P waters");
  auto* const accuracy = app.add_option("--accuracy", o->accuracy, "largest R of a run: \"0.5 %\"");
  auto* const drift =
      app.add_option("--drift", o->drift, "largest energy drift per molecule: \"0.1 kJ/mol/ns\"");
  app.add_option(
         "--temperature-bias", o->temperature_bias,
         "largest difference between the temperatures of translation and rotation: \"0.5 %\"")
      ->excludes(accuracy)
      ->excludes(drift);
  drift->excludes(accuracy);
  app.add_option("--schemes", o->schemes,
                 "names, or stages as text, instead of the run file's candidates");
  app.add_option("--length", o->length,
                 "length of the runs to be planned; default: the run file's");
  app.add_option("--time", o->seconds, "approximate computing time, in seconds")
      ->check(CLI::Range(0.1, 1e6))
      ->capture_default_str();
  app.add_option("--output", o->output, "prefix of the output files")->capture_default_str();
  app.add_option("--precision", o->precision,
                 "precision of pair interactions, double or mixed; default: the run file's");
  app.add_option("--threads", o->threads,
                 "number of simultaneous runs; default: one for each available core");
  app.add_flag("--force", o->force, "overwrite output files that exist");
  app.add_flag("--json", o->json, "print the advice as JSON");
  return [o] { return advise(*o); };
}

}  // namespace polhode::cli
