// SPDX-License-Identifier: MIT
// The settings of the tables [integrator], [run], [prepare], [output] and [study].
#include <fmt/core.h>

#include <algorithm>

#include "base/suggest.hpp"
#include "io/figures/plot.hpp"
#include "io/formats/format.hpp"
#include "io/settings/config_parts.hpp"
#include "io/settings/required_bias.hpp"
#include "polhode/base/error.hpp"
#include "polhode/io/settings/nested_scheme_text.hpp"
#include "setting_rows.hpp"

namespace polhode {
namespace {

constexpr SettingUnit fs{Dimension::time, "fs"}, ps{Dimension::time, "ps"};
constexpr SettingBounds equilibration = between(0, 1e12, " (one second)");

/// Parses a scheme from a text, after names of user-defined schemes are replaced by their texts.
/// @throws Error  with the place of the key, if the text is not a scheme
NamedScheme scheme_of(const std::string& text, const TomlTable& table, std::string_view key,
                      const Config& config) {
  return table.at(key, [&] { return NamedScheme(with_own_schemes(text, config.schemes)); });
}

void read_scheme(TomlTable& table, const SettingRow& row, Config& config) {
  const auto text = table.text(row.key);
  if (!text) return;
  table.require(!text->empty(), row.key, "must name a scheme, for example \"hoa2\"");
  config.integrator.scheme = scheme_of(*text, table, row.key, config);
}

void read_schemes(TomlTable& table, const SettingRow& row, Config& config) {
  auto texts = table.texts(row.key);
  if (!texts) return;
  table.require(!texts->empty(), row.key, "must name at least one scheme");
  for (std::string& text : *texts) text = scheme_of(text, table, row.key, config).text;
  row.member.set(config, *texts);
}

/// Reads a bound on R, such as "0.5 %", or on the bias of an average.
void read_accuracy(TomlTable& table, const SettingRow& row, Config& config) {
  std::optional<Requirement>& accuracy = config.integrator.accuracy;
  if (const auto text = table.holds_text(row.key) ? table.text(row.key) : std::nullopt;
      text && is_of_bias(*text)) {
    accuracy = table.at(row.key, [&] { return required_bias(*text, "accuracy"); });
  } else if (const auto ratio = table.quantity(row.key, *row.unit.dimension, row.unit.example)) {
    table.require(is_valid(row, *ratio), row.key, complaint(row));
    accuracy = Requirement{RequiredOf::ratio, *ratio};
  }
  table.require(!accuracy || !table.has("step"), row.key,
                "cannot be combined with a step, since the accuracy determines the step; leave one "
                "of the two out");
}

void read_steps(TomlTable& table, const SettingRow& row, Config& config) {
  for (const std::string& text : table.texts(row.key).value_or(std::vector<std::string>{})) {
    const double step = table.at(
        row.key, [&] { return quantity(text, Dimension::time, row.key, row.unit.example); });
    table.require(is_valid(row, step), row.key, complaint(row));
    config.study.steps.push_back(step);
  }
}

void read_prefix(TomlTable& table, const SettingRow& row, Config& config) {
  read_row(table, row, config);
  table.require(!config.output.prefix.empty(), row.key,
                "must not be empty: names of output files begin with it");
}

void read_formats(TomlTable& table, const SettingRow& row, Config& config) {
  read_row(table, row, config);
  std::vector<std::string> known;
  for (const std::string_view format : writable_formats()) known.emplace_back(format);
  for (const std::string& format : config.output.formats) {
    table.require(std::find(known.begin(), known.end(), format) != known.end(), row.key,
                  fmt::format("has the unknown format '{}'{}; the formats are: {}", format,
                              did_you_mean(format, known), join_names(known)));
    table.require(std::ranges::count(config.output.formats, format) == 1, row.key,
                  fmt::format("has the format '{}' twice; give each format once", format));
    table.require(format != "h5md" || h5md_missing.empty(), row.key,
                  fmt::format("has the format 'h5md': {}", h5md_missing));
  }
}

/// Restricts a text setting to a list of names.
SettingMember named(SettingMember one, std::span<const std::string_view> names) {
  one.names = names;
  return one;
}

}  // namespace

SettingTable integrator_table() {
  using I = IntegratorSettings;
  const auto integrator = in(&Config::integrator);
  return {
      "integrator",
      {row("scheme", integrator(&I::scheme),
           "splitting [scheme](schemes.md), given by name or stages, or two schemes for [multiple "
           "time steps](schemes.md#multiple-time-steps)",
           More{.read = read_scheme}),
       row("step", integrator(&I::step), fs, above(0), "time step h"),
       row("accuracy", SettingUnit{Dimension::fraction, "%", "0.5 %"},
           SettingBounds{.min = 0,
                         .max = 100,
                         .above = true,
                         .below = true,
                         .hint = ": it bounds R, the fluctuation of the total energy divided by "
                                 "the fluctuation of the potential energy"},
           "upper bound on R, or on [the bias of an average](advise.md#requirements): the "
           "[adviser](advise.md#in-a-run-file) chooses the step, and the scheme if none is given; "
           "cannot be combined with `step`",
           More{.domain = "0 % < fraction < 100 %; or `\"0.1 K\"`, `\"energy 0.01 kJ/mol\"`, "
                          "`\"pressure 4 bar\"`, `\"density 0.02 %\"`",
                .read = read_accuracy,
                .kinds = {SettingKind::text, SettingKind::quantity}}),
       row("candidates", integrator(&I::candidates),
           "single or nested schemes from which the [adviser](advise.md) chooses; each default "
           "scheme is the cheapest at some R [for liquids](../all-schemes.md)",
           More{.read = read_schemes, .free = true}),
       row("lambda", integrator(&I::lambda),
           above_to(0, 1, ": it scales the displacement of the finite difference"),
           "displacement of [finite-difference gradient kicks](../theory-forces.md#precision), as "
           "in `gier4-fd`, at least 0.1 in mixed precision; exact gradient kicks do not use "
           "`lambda`",
           More{.fallback = "1e-4; 1 in mixed precision"})}};
}

SettingTable run_table() {
  using R = RunSettings;
  const auto run = in(&Config::run);
  return {
      "run",
      {row("minimise", run(&R::minimise),
           "[minimises the energy](minimise.md) of the initial configuration first, with the "
           "default bounds of `polhode minimise`; molecules may overlap in this configuration"),
       row("equilibrate", run(&R::equilibrate), SettingUnit{Dimension::time, "ps", "5 ps"},
           equilibration, "length of the equilibration before the run, with velocity rescaling"),
       row("length", run(&R::length), ps, above(0),
           "length of the run, rounded to whole steps, at least one step", More{.free = true}),
       row("sample", run(&R::sample), fs, above(0),
           "interval between samples of the energies, rounded down to whole steps, at least one "
           "step"),
       row("shadow_sample", run(&R::shadow_sample), SettingUnit{Dimension::time, "fs", "100 fs"},
           from(0, "; 0 fs means no shadow energy"),
           "interval between values of the [shadow energy](../theory.md#the-shadow-energy), "
           "rounded down to whole samples; 0 fs switches it off. The shadow energy requires a "
           "scheme of order 2 without an inner scheme, and constant energy or the rescaling "
           "thermostat",
           More{.fallback = "100 steps; none for schemes without a shadow energy",
                .not_set = "default"}),
       row("configurational_sample", run(&R::configurational_sample),
           SettingUnit{Dimension::time, "fs", "20 fs"},
           from(0, "; 0 fs means no configurational temperature"),
           "interval between values of the [configurational "
           "temperatures](../theory.md#equipartition), rounded down to whole samples; 0 fs "
           "switches them off. Each value costs about two force evaluations, with any scheme")}};
}

SettingTable prepare_table() {
  const auto prepare = in(&Config::prepare);
  return {
      "prepare",
      {row("nvt", prepare(&PreparationSettings::nvt), ps, equilibration,
           "length of the constant-volume stage of [prepare](prepare.md)", More{.free = true}),
       row("npt", prepare(&PreparationSettings::npt), ps, equilibration,
           "length of the constant-pressure stage of [prepare](prepare.md), if there is a barostat",
           More{.free = true})}};
}

SettingTable output_table() {
  using O = OutputSettings;
  const auto output = in(&Config::output);
  return {"output",
          {row("prefix", output(&O::prefix),
               "prefix of output file names (the prefix must not end in `/`); a relative prefix "
               "begins at the working directory",
               More{.read = read_prefix, .free = true}),
           row("trajectory_every", output(&O::trajectory_every), ps,
               from(0, "; 0 ps means no trajectory"),
               "interval between frames; 0 ps writes no trajectory. A frame is written at the "
               "first energy sample after each interval, so give a multiple of `sample`"),
           row("formats", output(&O::formats),
               "[formats](formats.md) of the trajectory, given by file extensions; each format "
               "gives a separate file",
               More{.domain = "list of [formats](formats.md)", .read = read_formats}),
           row("massless_sites", output(&O::massless_sites),
               "whether the trajectory includes massless sites, such as M of TIP4P"),
           row("velocities", output(&O::velocities),
               "whether the trajectory includes velocities, in formats that support them"),
           row("pressure_tensor", output(&O::pressure_tensor),
               "whether the energies file contains the six components of the [molecular pressure "
               "tensor](../theory.md#pressure); external forces must then have a virial"),
           row("processed", output(&O::processed),
               "whether energies and frames are read through a "
               "[postprocessor](../processed-states.md), which makes their time-step errors "
               "smaller. Postprocessors are known for `velocity-verlet`, `takahashi-imada(-fd)` "
               "and `gier4(-fd)`. Each sample costs 3 to 5 force evaluations. Only `run` and "
               "`study` at constant energy use this setting"),
           row("plot", named(output(&O::plot), plot_formats),
               "format of the figure of the energies", More{.free = true}),
           row("checkpoint_every", output(&O::checkpoint_every),
               SettingUnit{Dimension::wall_clock, "min"}, above(0),
               "wall-clock interval between [checkpoints](checkpoints.md); a checkpoint is also "
               "written at the start, on interrupt and at the end",
               More{.free = true})}};
}

SettingTable study_table() {
  using S = StudySettings;
  const auto study = in(&Config::study);
  return {
      "study",
      {row("ensemble", study(&S::ensemble),
           "measure of accuracy, R or the bias of [canonical "
           "averages](study.md#canonical-averages)",
           More{.free = true}),
       row("schemes", study(&S::schemes),
           "single or nested schemes to compare; a [scheme of your "
           "own](schemes.md#schemes-of-your-own) can be named, as in `\"mine: B(1/6) A(1/2) ...\"`",
           More{.read = read_schemes, .free = true}),
       row("steps", SettingUnit{Dimension::time, "fs", "2 fs"}, above(0), "time steps",
           More{.domain = "list of times > 0 fs",
                .fallback = "a series of steps for each scheme",
                .read = read_steps,
                .kinds = {SettingKind::texts}}),
       row("runs", study(&S::runs), between(2, 1e6, ", for an error bar"),
           "number of independent runs for each scheme and step", More{.free = true}),
       row("length", study(&S::length), ps, above(0), "length of each run", More{.free = true}),
       row("decorrelate", study(&S::decorrelate), ps, equilibration,
           "equilibration time of each initial configuration after new momenta are drawn",
           More{.free = true}),
       row("configurational_sample", study(&S::configurational_sample),
           SettingUnit{Dimension::time, "fs", "20 fs"},
           from(0, "; 0 fs means no configurational temperature"),
           "interval between values of the configurational temperatures; 0 fs switches them off",
           More{.free = true})}};
}

}  // namespace polhode
