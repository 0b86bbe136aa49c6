// SPDX-License-Identifier: MIT
#include "analyze_options.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

#include "base/suggest.hpp"
#include "option_values.hpp"
#include "polhode/base/error.hpp"
#include "polhode/io/figures/plot.hpp"
#include "polhode/io/topology/molecule_file.hpp"
#include "polhode/run/simulation/system/system.hpp"

namespace polhode::cli {
namespace {

/// Splits "a, b" into words.
std::vector<std::string> words(const std::string& text) {
  std::vector<std::string> found;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    const auto first = part.find_first_not_of(' '), last = part.find_last_not_of(' ');
    if (first != part.npos) found.push_back(part.substr(first, last - first + 1));
  }
  return found;
}

/// "tip4p 512, na 4": models with their counts, in the order of the file.
Topology molecules_option(const std::string& text) {
  Topology topology;
  for (const std::string& word : words(text)) {
    std::istringstream parts(word);
    std::string model;
    long long count = 0;  // signed, since streams read "-1" as the largest number without a sign
    parts >> model;
    if (!(parts >> std::ws).eof() && (!(parts >> count) || !parts.eof() || count <= 0))
      throw Error(
          fmt::format("--molecules \"{}\": '{}' must be a model and its count; write for "
                      "example \"tip4p 512, na-tip4p-ew 4\"",
                      text, word));
    topology.parts.push_back({read_molecule(model), static_cast<std::size_t>(count)});
  }
  if (topology.parts.empty())
    throw Error("--molecules names no model; write for example \"tip4p 512\"");
  if (topology.parts.size() > 1)
    for (const auto& [molecule, count] : topology.parts)
      if (count == 0)
        throw Error(
            fmt::format("--molecules \"{}\": '{}' has no count; the count can be left out only if "
                        "there is one model",
                        text, molecule.name));
  return topology;
}

void set_surroundings(SummarySettings& settings, const std::string& electrostatics) {
  ForceSettings forces;
  forces.electrostatics = named_option<Electrostatics>(electrostatics, "--electrostatics");
  settings.set_surroundings(forces);
}

double positive(const std::string& text, Dimension dimension, const std::string& option) {
  const double value = quantity(text, dimension, option);
  if (!(value > 0)) throw Error(fmt::format("{} = \"{}\" must be above 0", option, text));
  return value;
}

/// "OW-HW": two selections of sites. Names may contain '-', too: it is split where both exist.
SitePair pair_option(const std::string& word, const Topology& topology) {
  const auto dash = word.find('-');
  if (dash == word.npos || dash == 0 || word.back() == '-')
    throw Error(fmt::format(
        "--pairs: '{}' must be two site names; write for example \"OW-OW, OW-HW\"", word));
  const auto split = [&](std::size_t at) {
    return SitePair{word.substr(0, at), word.substr(at + 1)};
  };
  for (auto at = dash; at != word.npos; at = word.find('-', at + 1)) {
    SitePair pair = split(at);
    if (!molecules_with(topology, pair[0]).empty() && !molecules_with(topology, pair[1]).empty())
      return pair;
  }
  return split(dash);
}

AnalysisSettings analysis_settings(const AnalyzeOptions& o, const Topology& topology) {
  AnalysisSettings s;
  for (const std::string& name : words(o.what)) s.what.insert(observable(name));
  s.from = o.from.empty() ? -std::numeric_limits<double>::infinity()
                          : quantity(o.from, Dimension::time, "--from");
  if (!o.interval.empty()) s.interval = positive_time(o.interval, "--interval");
  if (!o.window.empty()) s.window = positive_time(o.window, "--window");
  if (!o.cutoff.empty()) s.cutoff = positive(o.cutoff, Dimension::length, "--cutoff");
  if (!o.bin.empty()) s.bin = positive(o.bin, Dimension::length, "--bin");
  for (const std::string& word : words(o.pairs)) s.pairs.push_back(pair_option(word, topology));
  if (s.cutoff && *s.cutoff < s.bin)
    throw Error(
        fmt::format("--cutoff of {:g} nm is shorter than a bin of {:g} nm; give a longer "
                    "one",
                    *s.cutoff, s.bin));
  return s;
}

SummarySettings summary_settings(const AnalyzeOptions& o, const std::optional<Config>& config) {
  SummarySettings s;
  s.no_surroundings = "it depends on the electrostatics of the run; give --run or --electrostatics";
  if (config) s.set_run(*config);
  if (!o.electrostatics.empty()) set_surroundings(s, o.electrostatics);
  if (!o.temperature.empty())
    s.temperature = positive(o.temperature, Dimension::temperature, "--temperature");
  if (!o.viscosity.empty())
    s.viscosity = positive(o.viscosity, Dimension::viscosity, "--viscosity");
  if (!o.fit.empty()) {
    const std::vector<std::string> ends = words(o.fit);
    if (ends.size() != 2)
      throw Error(
          fmt::format("--fit \"{}\" must be two lags; write for example \"2 ps, 10 ps\"", o.fit));
    s.fit = FitWindow{quantity(ends[0], Dimension::time, "--fit"),
                      quantity(ends[1], Dimension::time, "--fit")};
    if (!(0 <= s.fit->from && s.fit->from < s.fit->to))
      throw Error(
          fmt::format("--fit \"{}\" must begin at 0 or later and end after its beginning; write "
                      "for example \"2 ps, 10 ps\"",
                      o.fit));
  }
  return s;
}

StepErrorSettings step_errors(const std::string& energies, const std::optional<Config>& config) {
  if (!config)
    throw Error(
        "--energies is for the bias of the step, which depends on what the run held constant; give "
        "--run water.toml");
  return step_error_settings(energies, *config);
}

}  // namespace

AnalysisInput analysis_input(const AnalyzeOptions& o) {
  if (o.run.empty() == o.molecules.empty())
    throw Error(
        "the molecules of the trajectory are not known; give one of --run water.toml and "
        "--molecules \"tip4p 512\"");
  if (std::find(plot_formats.begin(), plot_formats.end(), o.plot) == plot_formats.end())
    throw Error(fmt::format("--plot = \"{}\" {}", o.plot, must_be_one_of(plot_formats, o.plot)));
  std::optional<Config> config;
  if (!o.run.empty()) config = read_config(o.run);
  Topology topology = config ? build_topology(config->system) : molecules_option(o.molecules);
  AnalysisSettings settings = analysis_settings(o, topology);
  if (!o.energies.empty()) settings.step_errors = step_errors(o.energies, config);
  return {.trajectory = o.trajectory,
          .names = o.names,
          .topology = std::move(topology),
          .origin = config ? config->text : o.molecules,
          .seed = config ? config->system.seed : 0,
          .settings = std::move(settings),
          .summary = summary_settings(o, config),
          .prefix = o.output,
          .plot = o.plot};
}

std::string analyze_command(const AnalyzeOptions& o) {
  return typed_command("polhode analyze", {{"", o.trajectory},
                                           {"--run", o.run},
                                           {"--energies", o.energies},
                                           {"--molecules", o.molecules},
                                           {"--names", o.names},
                                           {"--what", o.what},
                                           {"--from", o.from},
                                           {"--interval", o.interval},
                                           {"--window", o.window},
                                           {"--fit", o.fit},
                                           {"--pairs", o.pairs},
                                           {"--cutoff", o.cutoff},
                                           {"--bin", o.bin},
                                           {"--viscosity", o.viscosity},
                                           {"--temperature", o.temperature},
                                           {"--electrostatics", o.electrostatics}});
}

}  // namespace polhode::cli
