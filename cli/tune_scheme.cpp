// SPDX-License-Identifier: MIT
// polhode tune-scheme [FILE]: η for hoa2's family and η, ξ for gier4's, for one system and step.
#include <fmt/core.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "interrupt.hpp"
#include "option_values.hpp"
#include "polhode/base/error.hpp"
#include "polhode/base/instruction_set.hpp"
#include "polhode/base/threads.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/io/nested_scheme_text.hpp"
#include "polhode/io/output_units.hpp"
#include "polhode/run/study/tune.hpp"
#include "progress.hpp"
#include "streams.hpp"
#include "system_notes.hpp"
#include "verbs.hpp"

namespace polhode::cli {
namespace {

struct Options {
  std::string file, step, length, decorrelate, sample, threads;
  int runs = TuneSettings{}.runs;
  bool json = false;
};

TuneSettings make_settings(const Options& o, const Config& config) {
  try {
    single_scheme_of(config.integrator.scheme);
  } catch (const Error& e) {
    throw e.at(config.source);
  }
  TuneSettings settings;
  settings.step = o.step.empty() ? config.integrator.step : positive_time(o.step, "--step");
  settings.runs = o.runs;
  if (!o.length.empty()) settings.length = positive_time(o.length, "--length");
  if (!o.decorrelate.empty()) settings.decorrelate = positive_time(o.decorrelate, "--decorrelate");
  if (!o.sample.empty()) settings.sample = positive_time(o.sample, "--sample");
  constexpr double min_repeats = 20;  // for covariances of three quantities
  if (settings.length < min_repeats * settings.sample)
    throw Error(fmt::format(
        "length {:g} fs is shorter than {:g} samples of the error brackets, {:g} fs "
        "apart; take longer runs, or a shorter --sample",
        settings.length * units::fs_per_ps, min_repeats, settings.sample * units::fs_per_ps));
  return settings;
}

double correlation(const ErrorCovariance& c) { return c.ab / std::sqrt(c.aa * c.bb); }

nlohmann::json as_json(const Tuned& t) {
  return {{"reference", t.reference.name()},
          {"scheme", text_of(t.scheme)},
          {"eta", t.member.eta},
          {"eta_error", t.error.eta},
          {"xi", t.member.xi},
          {"xi_error", t.error.xi},
          {"predicted_gain", t.predicted_gain},
          {"R_reference", t.reference_ratio.value},
          {"R_reference_error", t.reference_ratio.error},
          {"R", t.ratio.value},
          {"R_error", t.ratio.error},
          {"gain", t.gain.value},
          {"gain_error", t.gain.error}};
}

void print(const Tuned& t) {
  const auto ratio = [](const Estimate& R) {
    return fmt::format("{:.4g} ± {:.2g}", 100 * R.value, 100 * R.error);
  };
  fmt::print("\nfamily of {}\n", t.reference.name());
  fmt::print("  eta               {:.5f} ± {:.2g}\n", t.member.eta, t.error.eta);
  if (t.member.xi != 0)
    fmt::print("  xi                {:.5f} ± {:.2g}\n", t.member.xi, t.error.xi);
  fmt::print("  R                 {} %, {} for {}\n", ratio(t.ratio), ratio(t.reference_ratio),
             t.reference.name());
  fmt::print("  gain              {:.3f} ± {:.2g} measured, {:.3f} predicted\n", t.gain.value,
             t.gain.error, t.predicted_gain);
  fmt::print("  as text           \"{}\"\n", text_of(t.scheme));
}

int tune_scheme(const Options& o) {
  const Config config = o.file.empty() ? default_config() : read_config(o.file);
  const TuneSettings settings = make_settings(o, config);
  Workers workers(requested_threads(o.threads));
  const System system = build_system(config);
  log("polhode {}: tuning for {} molecules at {:g} fs, {} runs of {:g} ps that measure and {} that "
      "confirm, instruction set {}, threads {}\n",
      POLHODE_VERSION, system.topology.size(), settings.step * units::fs_per_ps, settings.runs,
      settings.length, settings.runs, name(current_instruction_set()), workers.threads());
  note_molecules(system);
  note_forces(system);

  catch_interrupts();
  TuneResult result = [&] {
    Progress progress("tuning");
    return tune(
        config, settings,
        {[&](double done, const std::string& what) { progress.show(done, what); }, interrupted},
        workers);
  }();
  if (interrupted()) {
    log("interrupted before a result was found\n");
    return 130;
  }

  const ErrorCovariance& c = result.covariance;
  const auto rms = [&](double squares) { return std::sqrt(squares / settings.runs); };
  if (o.json) {
    fmt::print("{}\n", nlohmann::json{{"molecules", system.topology.size()},
                                      {"step_fs", settings.step * units::fs_per_ps},
                                      {"runs", settings.runs},
                                      {"length_ps", settings.length},
                                      {"rms_first_bracket_kJ_per_mol", rms(c.aa)},
                                      {"rms_second_bracket_kJ_per_mol", rms(c.bb)},
                                      {"correlation", correlation(c)},
                                      {"eta_of_short_steps", result.short_steps},
                                      {"plain", as_json(result.plain)},
                                      {"gradient", as_json(result.gradient)}}
                           .dump(2));
    return 0;
  }
  fmt::print("error brackets, times h²: rms {:.4g} and {:.4g} kJ/mol, correlation {:.3f}\n",
             rms(c.aa), rms(c.bb), correlation(c));
  fmt::print("eta of short steps: {:.5f}\n", result.short_steps);
  print(result.plain);
  print(result.gradient);
  return 0;
}

}  // namespace

Action tune_scheme_verb(CLI::App& app) {
  auto o = std::make_shared<Options>();
  app.add_option("FILE", o->file, "run file (TOML); default: 512 TIP4P waters");
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
