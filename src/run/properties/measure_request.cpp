// SPDX-License-Identifier: MIT
#include "run/properties/measure_request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>

#include "io/files/split_words.hpp"
#include "io/files/text_file.hpp"
#include "polhode/base/error.hpp"
#include "polhode/integrate/error_terms.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/integrate/with_bath.hpp"
#include "polhode/run/prepare/preparation.hpp"
#include "polhode/run/simulation/system/system.hpp"
#include "run/properties/input_files.hpp"
#include "run/properties/property.hpp"

namespace polhode {
namespace {

constexpr std::uint64_t usual_molecules = 256;  // default number of molecules of a pure substance
constexpr std::uint64_t max_molecules = 1'000'000, max_replicas = 1000;
constexpr double max_cutoff = 0.9;        // maximum cutoff [nm]
constexpr double cutoff_per_edge = 0.45;  // of the box at its estimated density

/// A model with its number of molecules; 0 if the number is not given.
struct Component {
  std::string model;
  std::uint64_t count = 0;
};

/// Parses the components of a system, such as "spce 488" in "spce 488, na-spce 12".
std::vector<Component> components_of(const std::string& system) {
  std::vector<Component> list;
  for (const std::string_view part : parts_of(system, ',')) {
    if (part.empty())
      throw Error(fmt::format("'{}' has an empty part; write \"spce 488, na-spce 12\"", system));
    const auto space = part.rfind(' ');
    Component component{std::string(part), 0};
    if (space != part.npos && part.find_first_not_of("0123456789", space + 1) == part.npos) {
      const std::string number(part.substr(space + 1));
      component.count = given_whole_number({number, system}, 1, max_molecules);
      component.model = trimmed(part.substr(0, space));
    }
    list.push_back(component);
  }
  return list;
}

bool is_run_file(const std::string& path) {
  if (!std::filesystem::is_regular_file(path)) return false;
  const std::string text = file_text(path);
  return text.find("[system]") != text.npos;
}

/// The settings of a run with only these molecules.
Config config_of(const std::string& system, const Given& molecules, const Given& mixing,
                 const Given& solute) {
  std::vector<Component> components = components_of(system);
  const std::uint64_t default_count =
      molecules ? given_whole_number(molecules, min_of_liquid, max_molecules) : usual_molecules;
  if (components.size() > 1 && molecules)
    refuse(molecules, "has no meaning for a mixture: give the number of each kind of molecule");
  if (components.size() == 1 && components.front().count > 0 && molecules)
    refuse(molecules,
           fmt::format("has no meaning for '{}', which has a number of molecules", system));
  const bool is_mixture = components.size() > 1;
  if (solute) components.insert(components.begin(), {solute.text, 1});
  SystemSettings molecules_alone;
  bool charged = false;
  for (Component& c : components) {
    if (c.count == 0 && is_mixture)
      throw Error(
          fmt::format("'{}' has no number of molecules; write \"{} 100\"", c.model, c.model));
    molecules_alone.molecules.push_back({c.model, {}, c.count == 0 ? default_count : c.count});
    charged |= has_charges(molecule_of(molecules_alone.molecules.back()));
  }
  const Topology topology = build_topology(molecules_alone);
  const double edge = std::cbrt(topology.mass() / estimated_density(topology));
  // The rest is for the fluctuations of the volume, and for the error of the estimated density.
  const double share = topology.size() < 64 ? 0.4 : cutoff_per_edge;
  const double cutoff = std::min(max_cutoff, std::floor(share * edge * 100) / 100);
  Overlay overlay;
  if (mixing) overlay.settings = {{"forces.mixing", {mixing.text}, mixing.name}};
  Config config =
      parse_config(fmt::format("[system]\nmolecules = [{{ model = \"argon\", count = 1 }}]\n"
                               "density = \"1 g/cm3\"\n[forces]\ncutoff = \"{:g} nm\"\n"
                               "dispersion_correction = true\nprecision = \"mixed\"\n{}",
                               cutoff, charged ? "electrostatics = \"pme\"\n" : ""),
                   "measure", overlay);
  config.system.molecules = molecules_alone.molecules;
  config.system.density.reset();
  return config;
}

/// A note if the box is too small for the usual cutoff, which this program has then chosen shorter.
std::optional<std::string> short_cutoff(const Config& config) {
  const double cutoff = config.forces.cutoff;
  if (cutoff >= max_cutoff) return std::nullopt;
  const Topology topology = build_topology(config.system);
  const double volume = topology.mass() / estimated_density(topology);
  const double needed =
      static_cast<double>(topology.size()) * std::pow(max_cutoff / cutoff_per_edge, 3) / volume;
  const double digit = std::pow(10, std::floor(std::log10(needed)) - 1);  // the second one
  return fmt::format(
      "note: the box of {} molecules allows a cutoff of only {:g} nm, so values differ from larger "
      "systems; {:.0f} molecules have the usual cutoff of {:g} nm",
      topology.size(), cutoff, digit * std::ceil(needed / digit), max_cutoff);
}

/// Adds a molecule of the solute to the molecules of a run file.
void add_solute(Config& config, const Given& solute) {
  if (!config.system.initial_configuration.empty())
    refuse(
        solute,
        "has no meaning with an initial configuration; give one that contains the solute, as the "
        "first molecule of the run file");
  config.system.molecules.insert(config.system.molecules.begin(), {solute.text, {}, 1});
}

/// Parses a shard, such as "2/8" for the second of eight.
Shard shard_of(const Given& given) {
  const auto slash = given.text.find('/');
  if (slash == given.text.npos) refuse(given, "must be a part of a number of parts, \"2/8\"");
  const std::uint64_t count =
      given_whole_number({given.text.substr(slash + 1), given.name}, 1, max_replicas);
  const std::uint64_t index =
      given_whole_number({given.text.substr(0, slash), given.name}, 1, count);
  return {index - 1, count};
}

/// The state points of the option `at`, or a default one.
std::vector<StatePoint> points_of(const Given& at, const StatePoint& own) {
  std::vector<StatePoint> points;
  std::string_view rest = at.text;
  while (at && !rest.empty()) {
    const auto end = std::min(rest.find(';'), rest.size());
    try {
      for (const StatePoint& point : state_points(rest.substr(0, end))) points.push_back(point);
    } catch (const Error& e) {
      throw e.at(at.name);
    }
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  for (std::size_t k = 0; k < points.size(); ++k)
    for (std::size_t l = 0; l < k; ++l)
      if (points[k].file_text() == points[l].file_text())
        refuse(at, fmt::format("has two state points '{}', which would have the same files; state "
                               "points must differ in the first six digits",
                               points[k].text()));
  if (points.empty()) points = {own};
  return points;
}

/// Parses the requested error of a property, which is a fraction or has the unit of the property.
RequestedProperty with_error(const Property& property, const std::string& text) {
  RequestedProperty request{&property};
  const std::string unit = property.unit;
  std::string number = text;
  if (number.ends_with('%')) {
    number.pop_back();
    request.error = 0.01;
  } else if (!unit.empty() && number.ends_with(unit)) {
    number.resize(number.size() - unit.size());
    request.relative = false;
    request.error = 1;
  } else if (unit.empty()) {
    request.relative = false;
    request.error = 1;
  } else {
    throw Error(fmt::format("the error '{}' of {} must be in % or in {}: \"1 %\" or \"0.1 {}\"",
                            text, property.name, unit, unit));
  }
  while (number.ends_with(' ')) number.pop_back();
  request.error *= given_number({number, fmt::format("the error of {}", property.name)}, 1e-9, 1e9);
  return request;
}

constexpr std::array samplings{"molecular-dynamics", "hybrid-monte-carlo"};  // of Sampling

/// The text of a scheme, to which a bath can be added. A note says if its bias is not predicted.
std::string single_scheme(const Given& scheme, std::vector<std::string>& notes) {
  constexpr double rounding = 1e-12;
  try {
    const Scheme found = scheme_of(scheme.text);
    with_bath(found, BathPlace::ends);
    if (!found.palindromic()) throw Error("its stages are not a palindrome");
    const ErrorTerms terms = error_terms(found);
    if (std::hypot(terms.alpha, terms.beta) < rounding)
      notes.push_back(fmt::format(
          "note: {} has no error of order h², so its time-step bias is neither predicted nor "
          "subtracted",
          scheme.text));
  } catch (const Error& e) {
    refuse(scheme, fmt::format("is not suitable: {}", e.what()));
  }
  return scheme.text;
}

Sampling sampling_of(const Given& sampling) {
  for (std::size_t k = 0; k < samplings.size(); ++k)
    if (sampling.text == samplings[k]) return static_cast<Sampling>(k);
  refuse(sampling, fmt::format("must be {}", fmt::join(samplings, " or ")));
}

}  // namespace

std::vector<RequestedProperty> requested_properties(const std::vector<std::string>& words) {
  std::vector<RequestedProperty> list;
  bool has_error = true;  // whether the last property has an error, so that no other may follow
  for (const std::string& word : words) {
    const bool is_error =
        !word.empty() && (std::isdigit(static_cast<unsigned char>(word[0])) != 0 || word[0] == '.');
    if (is_error && has_error)
      throw Error(fmt::format(
          "'{}' must follow the name of a property; write for example density \"0.1 %\"", word));
    if (is_error)
      list.back() = with_error(*list.back().property, word);
    else
      list.push_back({&property(word)});
    has_error = is_error;
  }
  for (std::size_t k = 0; k < list.size(); ++k)
    for (std::size_t l = 0; l < k; ++l)
      if (list[k].property == list[l].property)
        throw Error(fmt::format("{} is requested twice", list[k].property->name));
  return list;
}

std::string properties_help() {
  std::string names;
  for (const Property& p : properties())
    names += fmt::format("{}{}", names.empty() ? "" : ", ", p.name);
  return fmt::format(
      "names of properties, each with its standard error: density \"0.1 %\" viscosity \"3 %\"; "
      "default error: {:g} %; names: {}",
      100 * RequestedProperty{}.error, names);
}

std::vector<RequestOption<MeasureRequest>> MeasureRequest::options() {
  using R = MeasureRequest;
  const MeasureSettings defaults;
  return {
      {"at", &R::at,
       "state point or range, several separated by ';': \"298.15 K, 1 bar\", \"298.15 K, 997 "
       "kg/m3\" at constant volume, \"250 K to 320 K, 7 points\"; default: the state point of "
       "the run file or .mdp file, or \"298.15 K, 1 bar\""},
      {"molecules", &R::molecules,
       fmt::format("number of molecules of a pure substance; default: {}", usual_molecules)},
      {"mixing", &R::mixing,
       "mixing rule of unlike sites for a system of models: lorentz-berthelot or geometric; "
       "default: the rule of the models"},
      {"solute", &R::solute,
       "name of a model or molecule file: one molecule of it is added as the first kind, for "
       "its solvation-free-energy"},
      {"replicas", &R::replicas,
       fmt::format("number of independent simulations of each state point; default: {}",
                   defaults.replicas)},
      {"paired_runs", &R::paired_runs,
       "whether an eighth of the dynamics is repeated at half of the step to bound its "
       "time-step bias, for a quarter more time: yes or no; default: yes"},
      {"sampling", &R::sampling,
       fmt::format("sampling of averages, chemical potentials and slabs: {}; hybrid Monte Carlo "
                   "has no time-step bias; default: {}",
                   fmt::join(samplings, " or "), samplings.front())},
      {"scheme", &R::scheme,
       fmt::format("scheme of all runs, a palindrome without a bath; default: {}",
                   defaults.scheme)},
      {"step", &R::step, "time step of all runs: \"2 fs\"; default: a pilot chooses it"},
      {"time_limit", &R::time_limit,
       "wall-clock time after which the results so far are reported: \"600 s\", \"2 h\""},
      {"shard", &R::shard,
       "part of the replicas for this process: \"2/8\"; 'polhode merge' then reports the "
       "properties from all parts"},
      {"seed", &R::seed,
       fmt::format("seed of all replicas, a whole number; default: {}", SystemSettings{}.seed)},
      {"output", &R::output, "prefix of the output files; default: " + R{}.prefix()}};
}

MeasureSettings MeasureRequest::settings() const {
  const bool from_input = is_input_file(system), from_file = from_input || is_run_file(system);
  std::vector<std::string> words = properties, notes;
  MeasureSettings s{.config = from_input ? config_of_input(system, words, notes) : Config{}};
  if (!from_input)
    s.config = from_file ? read_config(system) : config_of(system, molecules, mixing, solute);
  if (from_input && solute)
    refuse(solute,
           "has no meaning with files of another program; give files that contain the solute");
  if (from_file && solute) add_solute(s.config, solute);
  s.notes = std::move(notes);
  if (from_file && molecules)
    refuse(
        molecules,
        "has no meaning with a run file or an input file, since it sets the number of molecules");
  if (from_file && mixing)
    refuse(
        mixing,
        "has no meaning with a run file or an input file; write mixing in [forces] of a run file");
  const Config& config = s.config;
  StatePoint own{from_file ? config.system.temperature : 298.15,
                 config.ensemble.barostat
                     ? config.ensemble.barostat->pressure
                     : given_quantity({"1 bar", "pressure"}, Dimension::pressure)};
  s.points = points_of(at, own);
  s.properties = requested_properties(words);
  if (s.properties.empty())
    throw Error(
        "no property is requested; write for example density \"0.1 %\"; 'polhode help measure' "
        "lists all");
  const bool simulates = std::ranges::any_of(s.properties, [](const RequestedProperty& p) {
    return p.property->measured_in != MeasuredIn::pair;
  });
  if (!from_file && simulates)
    if (const auto note = short_cutoff(config)) s.notes.push_back(*note);
  if (replicas) s.replicas = given_whole_number(replicas, 2, max_replicas);
  if (paired_runs && paired_runs.text != "yes" && paired_runs.text != "no")
    refuse(paired_runs, "must be yes or no");
  s.paired_runs = paired_runs.text != "no";
  if (sampling) s.sampling = sampling_of(sampling);
  if (scheme) s.scheme = single_scheme(scheme, s.notes);
  if (step) s.step = given_positive(step, Dimension::time, "2 fs");
  if (shard) s.shard = shard_of(shard);
  if (s.shard.count > s.replicas)
    refuse(shard, fmt::format("has more parts than there are replicas, {}", s.replicas));
  if (time_limit) s.time_limit = given_positive(time_limit, Dimension::wall_clock, "600 s");
  if (seed) s.config.system.seed = given_whole_number(seed, 0, ~std::uint64_t{0});
  s.prefix = prefix();
  return s;
}

}  // namespace polhode
