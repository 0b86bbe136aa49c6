// SPDX-License-Identifier: MIT
#include "run/analysis/analysis_request.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <sstream>

#include "base/suggest.hpp"
#include "io/figures/plot.hpp"
#include "polhode/io/topology/molecule_file.hpp"
#include "polhode/run/simulation/system/system.hpp"

namespace polhode {
namespace {

using Request = AnalysisRequest;

/// Parses models with their counts, in the order of the file, such as "tip4p 512, na 4".
Topology molecules_of(const Given& given) {
  Topology topology;
  for (const std::string& word : given_words(given)) {
    std::istringstream parts(word);
    std::string model;
    long long count = 0;  // signed, because streams read "-1" as the largest unsigned number
    parts >> model;
    if (!(parts >> std::ws).eof() && (!(parts >> count) || !parts.eof() || count <= 0))
      refuse(given, fmt::format("has the entry '{}'; each entry must be a model and its count: "
                                "write for example \"tip4p 512, na-tip4p-ew 4\"",
                                word));
    topology.parts.push_back({read_molecule(model), static_cast<std::size_t>(count)});
  }
  if (topology.parts.empty()) refuse(given, "names no model; write for example \"tip4p 512\"");
  if (topology.parts.size() > 1)
    for (const auto& [molecule, count] : topology.parts)
      if (count == 0)
        refuse(
            given,
            fmt::format("has no count of '{}'; a count can be left out only if there is one model",
                        molecule.name));
  return topology;
}

/// Parses two selections of sites, such as "OW-HW". Names may also contain '-', so the text is
/// split at the '-' for which both selections exist.
SitePair pair_of(const Given& given, const std::string& word, const Topology& topology) {
  const auto dash = word.find('-');
  if (dash == word.npos || dash == 0 || word.back() == '-')
    refuse(given, fmt::format("has the entry '{}'; each entry must be two site names: write for "
                              "example \"OW-OW, OW-HW\"",
                              word));
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

AnalysisSettings settings_of(const Request& r, const Topology& topology) {
  AnalysisSettings s;
  for (const std::string& name : given_words(r.what)) s.what.insert(observable(name));
  s.from =
      r.start ? given_quantity(r.start, Dimension::time) : -std::numeric_limits<double>::infinity();
  if (r.interval) s.interval = given_positive(r.interval, Dimension::time);
  if (r.window) s.window = given_positive(r.window, Dimension::time);
  if (r.cutoff) s.cutoff = given_positive(r.cutoff, Dimension::length);
  take_positive(s.bin, r.bin, Dimension::length);
  for (const std::string& word : given_words(r.pairs)) {
    const SitePair pair = pair_of(r.pairs, word, topology);
    for (const SitePair& same : {pair, SitePair{pair[1], pair[0]}})
      if (std::find(s.pairs.begin(), s.pairs.end(), same) != s.pairs.end())
        refuse(r.pairs, fmt::format("has the pair '{}' twice; delete one of the two", word));
    s.pairs.push_back(pair);
  }
  if (s.cutoff && *s.cutoff < s.bin)
    refuse(r.cutoff,
           fmt::format("is shorter than a bin of {:g} nm; give a longer distance", s.bin));
  return s;
}

FitWindow fit_window(const Given& fit) {
  const std::vector<std::string> ends = given_words(fit);
  if (ends.size() != 2) refuse(fit, "must be two lags; write for example \"2 ps, 10 ps\"");
  const FitWindow window{given_quantity({ends[0], fit.name}, Dimension::time),
                         given_quantity({ends[1], fit.name}, Dimension::time)};
  if (!(0 <= window.from && window.from < window.to))
    refuse(fit,
           "must begin at 0 or later and end at a later lag; write for example \"2 ps, 10 ps\"");
  return window;
}

SummarySettings summary_settings(const Request& r, const Config* run) {
  SummarySettings s;
  s.no_surroundings =
      fmt::format("the dielectric constant depends on the electrostatics of the run; give {} or {}",
                  r.run.name, r.electrostatics.name);
  if (run != nullptr) s.set_run(*run);
  if (r.electrostatics) {
    ForceSettings forces;
    forces.electrostatics = given_name<Electrostatics>(r.electrostatics);
    s.set_surroundings(forces);
  }
  if (r.temperature) s.temperature = given_positive(r.temperature, Dimension::temperature);
  if (r.viscosity) s.viscosity = given_positive(r.viscosity, Dimension::viscosity);
  if (r.fit) s.fit = fit_window(r.fit);
  return s;
}

}  // namespace

std::vector<RequestOption<Request>> Request::options() {
  const AnalysisSettings defaults;
  return {
      {"run", &Request::run,
       "run file of the trajectory, which gives molecules and electrostatics"},
      {"energies", &Request::energies,
       "energies file of the run, for the time-step bias of g(r) and the dielectric constant; "
       "requires --run"},
      {"molecules", &Request::molecules,
       "models and counts in the order of the file, instead of a run file: \"tip4p 512, "
       "na-tip4p-ew 4\""},
      {"names", &Request::names, "coordinate file with the atom names, for formats without them"},
      {"what", &Request::what,
       fmt::format("observables: {}; default: all that the frames allow",
                   join_names(observable_names()))},
      {"output", &Request::output,
       fmt::format("prefix of the output files; default: {}", AnalysisInput{}.prefix)},
      {"start", &Request::start, "leave out frames before this time: \"10 ps\"", "from"},
      {"interval", &Request::interval,
       "time between frames, instead of the times in the file: \"0.1 ps\""},
      {"window", &Request::window,
       fmt::format("maximum lag of correlations; default: \"{:g} ps\"", default_window)},
      {"fit", &Request::fit,
       "range of lags for the straight-line fit that gives D: \"2 ps, 10 ps\"; default: from a "
       "fifth of the maximum lag to the maximum lag"},
      {"pairs", &Request::pairs,
       "site pairs of g(r): \"OW-OW, OW-HW\"; HW means HW1 and HW2; default: all pairs"},
      {"cutoff", &Request::cutoff,
       fmt::format("maximum distance of g(r); default: \"{:g} nm\", or half of the shortest edge",
                   default_rdf_cutoff)},
      {"bin", &Request::bin, fmt::format("bin width of g(r); default: \"{:g} nm\"", defaults.bin)},
      {"viscosity", &Request::viscosity,
       "viscosity of the liquid, \"0.855 mPa s\", for the Yeh-Hummer finite-size correction of D; "
       "default: the published value of the model"},
      {"temperature", &Request::temperature,
       "temperature, \"298 K\"; default: the temperature of the velocities, or of the run file"},
      {"electrostatics", &Request::electrostatics,
       fmt::format("electrostatics of the run, instead of the setting in the run file: pme, "
                   "reaction-field (relative permittivity {:g}), coulomb",
                   ForceSettings{}.dielectric)},
      {"plot", &Request::plot,
       fmt::format("format of figures: {}; default: {}", fmt::join(plot_formats, ", "),
                   AnalysisInput{}.plot)}};
}

AnalysisInput analysis_input(const Request& request, const std::string& trajectory,
                             const Config* run) {
  std::optional<Config> of_file;
  if (request.run) run = &of_file.emplace(read_config(request.run.text));
  if ((run == nullptr) != static_cast<bool>(request.molecules))
    throw Error(fmt::format(
        "the molecules of the trajectory are {}; give either {} water.toml or {} \"tip4p 512\"",
        run == nullptr ? "not known" : "given twice", request.run.name, request.molecules.name));
  if (request.energies && run == nullptr)
    throw Error(
        fmt::format("{} is used for the time-step bias, but this bias depends on the ensemble of "
                    "the run; also give {} water.toml",
                    request.energies.name, request.run.name));
  AnalysisInput input{.trajectory = trajectory, .names = request.names.text};
  if (request.output) input.prefix = request.output.text;
  if (request.plot) input.plot = request.plot.text;
  if (std::ranges::find(plot_formats, input.plot) == plot_formats.end())
    refuse(request.plot, must_be_one_of(plot_formats, input.plot));
  input.topology = run != nullptr ? build_topology(run->system) : molecules_of(request.molecules);
  input.origin = run != nullptr ? run->text : request.molecules.text;
  if (run != nullptr) input.seed = run->system.seed;
  input.settings = settings_of(request, input.topology);
  if (request.energies)
    input.settings.step_errors = step_error_settings(request.energies.text, *run);
  input.summary = summary_settings(request, run);
  return input;
}

}  // namespace polhode
