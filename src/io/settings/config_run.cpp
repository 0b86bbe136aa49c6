// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>

#include "base/suggest.hpp"
#include "config_tables.hpp"
#include "io/formats/format.hpp"
#include "polhode/base/error.hpp"
#include "polhode/io/figures/plot.hpp"
#include "polhode/io/settings/nested_scheme_text.hpp"

namespace polhode {
namespace {

/// The scheme of a name or text.
/// @throws Error  with the place of the key, if it is none
NamedScheme scheme_of(const std::string& text, std::string_view key, const TomlTable& table,
                      const OwnSchemes& own) {
  try {
    return with_own_schemes(text, own);
  } catch (const Error& e) {
    throw e.at(table.where(key));
  }
}

/// A list of schemes, if the key exists.
void take_schemes(TomlTable& table, std::string_view key, std::vector<NamedScheme>& schemes,
                  const OwnSchemes& own) {
  const auto texts = table.texts(key);
  if (!texts) return;
  table.require(!texts->empty(), key, "must name at least one scheme");
  schemes.clear();
  for (const std::string& text : *texts) schemes.push_back(scheme_of(text, key, table, own));
}

/// "0.5 %" of R, or the bias of an average.
std::optional<Requirement> read_accuracy(TomlTable& table) {
  if (table.holds_text("accuracy"))
    if (const std::string text = *table.text("accuracy"); is_of_bias(text)) try {
        return required_bias(text, "accuracy");
      } catch (const Error& e) {
        throw Error(e.what(), table.where("accuracy"));
      }
  const auto ratio = table.quantity("accuracy", Dimension::fraction, "0.5 %");
  if (!ratio) return std::nullopt;
  if (const std::string wrong = wrong_bound(*ratio); !wrong.empty())
    table.refuse("accuracy", wrong +
                                 ": it bounds R, the fluctuation of the total energy divided "
                                 "by that of the potential energy");
  return Requirement{RequiredOf::ratio, *ratio};
}

void take_configurational_sample(TomlTable& table, double& interval) {
  take_time(table, "configurational_sample", interval, "20 fs");
  table.require(interval >= 0, "configurational_sample",
                "must be 0 fs or longer; 0 fs means no configurational temperature");
}

constexpr double max_equilibration = 1e12;  // [ps]
constexpr auto must_be_time = "must be 0 ps or longer, and at most 1e6 us (one second)";

}  // namespace

void read_integrator(TomlTable table, IntegratorSettings& integrator, const OwnSchemes& own) {
  integrator.scheme_given = table.has("scheme");
  if (const auto text = table.text("scheme")) {
    table.require(!text->empty(), "scheme", "must name a scheme, for example \"hoa2\"");
    integrator.scheme = scheme_of(*text, "scheme", table, own);
  }
  take_time(table, "step", integrator.step, "2 fs");
  table.require(integrator.step > 0, "step", "must be longer than 0 fs");
  integrator.accuracy = read_accuracy(table);
  table.require(!integrator.accuracy || !table.has("step"), "accuracy",
                "cannot be combined with a step, which it chooses itself; leave one out");
  take_schemes(table, "candidates", integrator.candidates, own);
  integrator.lambda_given = table.has("lambda");
  if (integrator.lambda_given) integrator.lambda_place = table.where("lambda");
  take(integrator.lambda, table.number("lambda"));
  table.require(
      integrator.lambda > 0 && integrator.lambda <= 1, "lambda",
      "must be above 0 and at most 1: it scales the displacement of the finite difference");
  table.refuse_unknown();
}

void read_run(TomlTable table, RunSettings& run) {
  take(run.minimise, table.boolean("minimise"));
  take_time(table, "equilibrate", run.equilibrate, "5 ps");
  table.require(run.equilibrate >= 0 && run.equilibrate <= max_equilibration, "equilibrate",
                must_be_time);
  take_time(table, "length", run.length, "15 ps");
  table.require(run.length > 0, "length", "must be longer than 0 ps");
  take_time(table, "sample", run.sample, "4 fs");
  table.require(run.sample > 0, "sample", "must be longer than 0 fs");
  run.shadow_sample = table.quantity("shadow_sample", Dimension::time, "100 fs");
  table.require(run.shadow_sample.value_or(0) >= 0, "shadow_sample",
                "must be 0 fs or longer; 0 fs means no shadow energy");
  take_configurational_sample(table, run.configurational_sample);
  table.refuse_unknown();
}

void read_preparation(TomlTable table, PreparationSettings& preparation) {
  const auto take_length = [&](std::string_view key, double& length, const char* example) {
    take_time(table, key, length, example);
    table.require(length >= 0 && length <= max_equilibration, key, must_be_time);
  };
  take_length("nvt", preparation.nvt, "20 ps");
  take_length("npt", preparation.npt, "100 ps");
  table.refuse_unknown();
}

void read_output(TomlTable table, OutputSettings& output) {
  take(output.prefix, table.text("prefix"));
  table.require(!output.prefix.empty(), "prefix",
                "must not be empty: names of output files begin with it");
  take_time(table, "trajectory_every", output.trajectory_every, "0.1 ps");
  table.require(output.trajectory_every >= 0, "trajectory_every",
                "must be 0 ps or longer; 0 ps means no trajectory");
  take(output.formats, table.texts("formats"));
  std::vector<std::string> known;
  for (const std::string_view format : writable_formats()) known.emplace_back(format);
  for (const std::string& format : output.formats) {
    table.require(std::find(known.begin(), known.end(), format) != known.end(), "formats",
                  fmt::format("has the unknown format '{}'{}; there are: {}", format,
                              did_you_mean(format, known), join_names(known)));
    table.require(format != "h5md" || h5md_missing.empty(), "formats",
                  fmt::format("has the format 'h5md': {}", h5md_missing));
  }
  take(output.massless_sites, table.boolean("massless_sites"));
  take(output.velocities, table.boolean("velocities"));
  output.plot = one_of(table, "plot", output.plot, plot_formats);
  take(output.checkpoint_every, table.quantity("checkpoint_every", Dimension::wall_clock));
  table.require(output.checkpoint_every > 0, "checkpoint_every", "must be longer than 0 s");
  table.refuse_unknown();
}

void read_study(TomlTable table, StudySettings& study, const OwnSchemes& own) {
  study.ensemble = one_of(table, "ensemble", study.ensemble);
  take_schemes(table, "schemes", study.schemes, own);
  for (const std::string& text : table.texts("steps").value_or(std::vector<std::string>{})) {
    try {
      study.steps.push_back(quantity(text, Dimension::time, "steps", "2 fs"));
    } catch (const Error& e) {
      throw e.at(table.where("steps"));
    }
    table.require(study.steps.back() > 0, "steps", "must all be longer than 0 fs");
  }
  const auto runs = table.integer("runs").value_or(study.runs);
  table.require(runs >= 2 && runs <= 1'000'000, "runs",
                "must be 2 or more, for an error bar, and not above a million");
  study.runs = static_cast<int>(runs);
  take_time(table, "length", study.length, "15 ps");
  table.require(study.length > 0, "length", "must be longer than 0 ps");
  take_time(table, "decorrelate", study.decorrelate, "10 ps");
  table.require(study.decorrelate >= 0 && study.decorrelate <= max_equilibration, "decorrelate",
                must_be_time);
  take_configurational_sample(table, study.configurational_sample);
  table.refuse_unknown();
}

}  // namespace polhode
