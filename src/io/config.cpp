// SPDX-License-Identifier: MIT
#include "polhode/io/config.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <limits>

#include "polhode/base/error.hpp"
#include "polhode/base/printable.hpp"
#include "polhode/base/suggest.hpp"
#include "polhode/forces/laws/damped_shifted_force.hpp"
#include "polhode/io/embedded.hpp"
#include "polhode/io/molecule_file.hpp"
#include "polhode/io/nested_scheme_text.hpp"
#include "polhode/model/topology.hpp"
#include "short_range_keys.hpp"
#include "text_file.hpp"
#include "toml_table.hpp"

namespace polhode {
namespace {

using std::filesystem::path;

template <class T>
void take(T& value, const std::optional<T>& found) {
  if (found) value = *found;
}

void take_time(TomlTable& table, std::string_view key, double& value, std::string_view example) {
  take(value, table.quantity(key, Dimension::time, example));
}

std::string one_of(TomlTable& table, std::string_view key, const std::string& fallback,
                   const std::vector<std::string>& names) {
  const std::string value = table.text(key).value_or(fallback);
  table.require(std::find(names.begin(), names.end(), value) != names.end(), key,
                fmt::format("must be one of: {}{}", join_names(names), did_you_mean(value, names)));
  return value;
}

std::string resolve(const path& folder, const std::string& name) {
  return (folder / name).lexically_normal().string();
}

SystemSettings::Component read_component(TomlTable table, const path& folder, bool from_file) {
  SystemSettings::Component component;
  const auto model = table.text("model");
  if (!model) table.refuse("model", "a molecule has no model; write for example model = \"tip4p\"");
  component.model = is_molecule_path(*model) ? resolve(folder, *model) : *model;
  const auto count = table.integer("count");
  table.refuse_unknown();
  if (!count && !from_file)
    table.refuse("count",
                 "a molecule has no count and there is no initial configuration to count "
                 "them in; write for example count = 512");
  table.require(count.value_or(0) >= (from_file ? 0 : 1), "count",
                from_file ? "must be 0 or more; 0 takes as many as the initial configuration holds"
                          : "must be 1 or more");
  component.count = static_cast<std::size_t>(count.value_or(0));
  try {
    read_molecule(component.model);
  } catch (const Error& e) {
    throw e.at(table.where("model"));
  }
  return component;
}

Vec3<double> read_box(TomlTable& table) {
  if (table.holds_text("box")) {
    const double edge = *table.quantity("box", Dimension::length, "2.5 nm");
    return {edge, edge, edge};
  }
  if (!table.holds_list("box"))  // reports a bare number, or a value of the wrong type
    table.quantity("box", Dimension::length, "2.5 nm");
  const auto edges = table.texts("box");
  table.require(edges->size() == 3, "box", "must be one edge or a list of three");
  Vec3<double> box;
  for (std::size_t k = 0; k < 3; ++k) {
    try {
      box[k] = quantity((*edges)[k], Dimension::length, fmt::format("box[{}]", k), "2.5 nm");
    } catch (const Error& e) {
      throw e.at(table.where("box"));
    }
  }
  return box;
}

void read_extent(TomlTable& table, SystemSettings& system) {
  system.density = table.quantity("density", Dimension::density);
  table.require(system.density.value_or(1) > 0, "density", "must be above 0 g/cm3");
  if (table.has("box")) system.box = read_box(table);
  if (system.box)
    table.require(std::min({system.box->x, system.box->y, system.box->z}) > 0, "box",
                  "must have edges longer than 0 nm");
  const bool start = !system.initial_configuration.empty();
  if (system.density && system.box)
    table.refuse("density", "stands beside a box, which fixes the density already; leave one out");
  if (start && (system.density || system.box))
    table.refuse(system.box ? "box" : "density",
                 "stands beside an initial configuration, which brings its own box; leave one out");
  if (!start && !system.density && !system.box)
    table.refuse("",
                 "there is neither a density nor a box nor an initial configuration; "
                 "write for example density = \"1 g/cm3\"");
}

void read_start(TomlTable& table, const path& folder, SystemSettings& system) {
  table.renamed("start", "initial_configuration");
  system.initial_configuration = table.text("initial_configuration").value_or("");
  if (system.initial_configuration.empty()) return;
  if (embedded_text("start/" + system.initial_configuration + ".gro")) return;
  std::string file = resolve(folder, system.initial_configuration);
  table.require(std::filesystem::is_regular_file(file), "initial_configuration",
                fmt::format("is no file and no initial configuration of the program; \"w512\" is "
                            "one, and a file would be '{}'",
                            file));
  system.initial_configuration = std::move(file);
}

std::vector<std::string> folders_beside(const path& folder, std::vector<std::string> names) {
  for (std::string& name : names) name = resolve(folder, name);
  return names;
}

// "NAME" or "NAME=VALUE", where the name is one that #ifdef accepts.
bool is_macro(std::string_view text) {
  const std::string_view name = text.substr(0, text.find('='));
  return !name.empty() && name.front() != '-' && name.find_first_of(" \t") == name.npos;
}

// The topology file. A LAMMPS data file is both topology and initial configuration.
void read_topology_keys(TomlTable& table, const path& folder, SystemSettings& system) {
  TopologySettings& topology = system.topology;
  topology.file = table.text("topology").value_or("");
  const bool given = !topology.file.empty();
  if (given) {
    topology.file = resolve(folder, topology.file);
    table.require(!table.has("molecules"), "topology",
                  "stands beside molecules, which it brings itself; leave one out");
    table.require(std::filesystem::is_regular_file(topology.file), "topology",
                  fmt::format("is no file; it would be '{}'", topology.file));
  } else if (is_data_file(system.initial_configuration) && !table.has("molecules")) {
    topology.file = system.initial_configuration;
  }
  if (given && system.initial_configuration.empty() && is_data_file(topology.file))
    system.initial_configuration = topology.file;
  if (given && system.initial_configuration.empty())
    table.refuse("topology",
                 "has no initial configuration beside it, whose atoms must stand in its order; "
                 "write for example "
                 "initial_configuration = \"conf.gro\"");
  const bool gromacs = given && !is_data_file(topology.file);
  for (const char* key : {"include", "define", "rigid"})
    table.require(gromacs || !table.has(key), key,
                  "has no meaning without a GROMACS topology; leave it out");
  take(topology.include, table.texts("include"));
  take(topology.define, table.texts("define"));
  for (const std::string& macro : topology.define)
    table.require(is_macro(macro), "define",
                  fmt::format("has '{}', which defines no macro that a topology could ask for; "
                              "write names, \"NAME\" or \"NAME=VALUE\", without -D",
                              macro));
  take(topology.rigid, table.texts("rigid"));
  topology.include = folders_beside(folder, std::move(topology.include));
}

void read_molecules(TomlTable& table, const path& folder, SystemSettings& system) {
  const auto components = table.tables("molecules");
  if (!components || components->empty())
    table.refuse("",
                 "there are no molecules; write for example "
                 "molecules = [{ model = \"tip4p\", count = 512 }]");
  for (const TomlTable& component : *components)
    system.molecules.push_back(
        read_component(component, folder, !system.initial_configuration.empty()));
  const auto open = [](const auto& component) { return component.count == 0; };
  if (system.molecules.size() > 1 &&
      std::any_of(system.molecules.begin(), system.molecules.end(), open))
    table.refuse("molecules",
                 "has several models, of which one has no count; only a single model "
                 "can be counted in the initial configuration");
}

void read_system(TomlTable table, const path& folder, SystemSettings& system) {
  read_start(table, folder, system);
  read_topology_keys(table, folder, system);
  if (system.topology.file.empty()) read_molecules(table, folder, system);
  read_extent(table, system);
  take(system.temperature, table.quantity("temperature", Dimension::temperature));
  table.require(system.temperature > 0, "temperature", "must be above 0 K; molecules move");
  const auto seed = table.integer("seed");
  table.require(seed.value_or(0) >= 0, "seed", "must be 0 or more");
  if (seed) system.seed = static_cast<std::uint64_t>(*seed);
  table.refuse_unknown();
}

double read_dielectric(TomlTable& table, const ForceSettings& forces) {
  double value = forces.dielectric;
  if (table.holds_text("dielectric")) {
    table.require(table.text("dielectric") == "infinite", "dielectric",
                  "must be a number of 1 or more, or \"infinite\"");
    value = std::numeric_limits<double>::infinity();
  } else {
    take(value, table.number("dielectric"));
    table.require(value >= 1, "dielectric", "must be 1 (vacuum) or more, or \"infinite\"");
  }
  return value;
}

void read_forces(TomlTable table, ForceSettings& forces) {
  const auto wanted = table.holds_text("electrostatics") ? table.text("electrostatics") : "";
  const bool pme = wanted == "pme", damped = wanted == "damped-shifted-force";
  const std::string truncation =
      one_of(table, "truncation", pme || damped ? "site-switch" : "molecule-switch",
             {"molecule-switch", "site-switch", "site-shift"});
  table.require(
      !(pme || damped) || truncation == "site-switch", "truncation",
      fmt::format("does not go with electrostatics = \"{}\": charges {}, and what the truncation "
                  "ends is Lennard-Jones alone, with \"site-switch\"; leave it out",
                  *wanted, pme ? "are summed over all images" : "end by their own law"));
  const bool by_molecule = truncation == "molecule-switch";
  forces.truncation = by_molecule                   ? Truncation::molecule_switch
                      : truncation == "site-switch" ? Truncation::site_switch
                                                    : Truncation::site_shift;
  // Unscreened Coulomb forces between single sites would be truncated where they are large.
  const std::string electrostatics =
      one_of(table, "electrostatics", by_molecule ? "coulomb" : "reaction-field",
             {"coulomb", "reaction-field", "damped-shifted-force", "pme"});
  forces.electrostatics = pme                           ? Electrostatics::pme
                          : damped                      ? Electrostatics::damped_shifted_force
                          : electrostatics == "coulomb" ? Electrostatics::coulomb
                                                        : Electrostatics::reaction_field;
  table.renamed("accuracy", "pme_accuracy");
  if (table.has("pme_accuracy")) {
    table.require(pme, "pme_accuracy",
                  "has no meaning without electrostatics = \"pme\"; leave it out");
    take(forces.pme_accuracy, table.number("pme_accuracy"));
    table.require(forces.pme_accuracy >= 1e-7 && forces.pme_accuracy <= 0.1, "pme_accuracy",
                  "must lie from 1e-7 to 0.1: the error of electrostatic forces over the forces, "
                  "both rms; 1e-4 is usual");
  }
  const std::string precision = one_of(table, "precision", "double", {"double", "mixed"});
  forces.precision = precision == "mixed" ? Precision::mixed : Precision::double_precision;
  const std::string mixing =
      one_of(table, "mixing", "lorentz-berthelot", {"lorentz-berthelot", "geometric"});
  forces.mixing.rule =
      mixing == "geometric" ? MixingRule::geometric : MixingRule::lorentz_berthelot;
  const auto cutoff = table.quantity("cutoff", Dimension::length);
  take(forces.cutoff, cutoff);
  table.require(forces.cutoff > 0, "cutoff", "must be longer than 0 nm");
  if (table.has("damping")) {
    table.require(damped, "damping",
                  "has no meaning without electrostatics = \"damped-shifted-force\"; leave it out");
    take(forces.damping, table.quantity("damping", Dimension::inverse_length, "2 1/nm"));
    table.require(forces.damping >= 0 && forces.damping * forces.cutoff <= max_damping, "damping",
                  fmt::format("must be 0 or more, and at most {:g} over the cutoff, {:.4g} 1/nm: "
                              "next to nothing is left of charges at the cutoff there; 2 1/nm is "
                              "usual",
                              max_damping, max_damping / forces.cutoff));
  }
  const auto from = table.quantity("switch", Dimension::length, "0.85 nm");
  // By default the switch covers the outer 15 % of the range: from 0.85 nm for a cutoff of 1 nm.
  forces.switch_from = from.value_or(0.85 * forces.cutoff);
  table.require(forces.switch_from > 0 && forces.switch_from < forces.cutoff, "switch",
                fmt::format("must be longer than 0 nm and shorter than the cutoff, {} nm: between "
                            "the two the forces fade",
                            forces.cutoff));
  const auto smoothness = table.integer("smoothness").value_or(forces.smoothness);
  table.require(smoothness >= 1 && smoothness <= 3, "smoothness",
                "must be 1, 2 or 3, the number of continuous derivatives of the switch");
  forces.smoothness = static_cast<int>(smoothness);
  if (table.has("dielectric")) {
    table.require(forces.electrostatics == Electrostatics::reaction_field, "dielectric",
                  "has no meaning without electrostatics = \"reaction-field\"; leave it out");
    forces.dielectric = read_dielectric(table, forces);
  }
  take(forces.dispersion_correction, table.boolean("dispersion_correction"));
  table.require(!forces.dispersion_correction || truncation != "site-shift",
                "dispersion_correction",
                "does not go with truncation = \"site-shift\", which changes the law at all "
                "distances; leave it out, or take \"site-switch\"");
  take(forces.skin, table.quantity("skin", Dimension::length, "0.1 nm"));
  table.require(forces.skin > 0, "skin",
                "must be longer than 0 nm, so that a list of neighbours lasts; 0.1 nm is usual");
  table.refuse_unknown();
}

PairOverride read_pair(TomlTable& table, const std::string& file) {
  const auto sites = table.texts("sites");
  if (!sites)
    table.refuse("sites",
                 "a pair has no sites; write for example sites = [\"tip4p.OW\", \"argon.Ar\"]");
  table.require(sites->size() == 2, "sites",
                "must be two, each a molecule and a site: [\"tip4p.OW\", \"argon.Ar\"]");
  const ShortRangeKeys keys = read_short_range(table, LawOwner::pair, file);
  table.refuse_unknown();
  return {(*sites)[0], (*sites)[1], keys.sigma, keys.epsilon, keys.law};
}

void read_pairs(const std::vector<TomlTable>& tables, const SystemSettings& system,
                const std::string& file, Mixing& mixing) {
  Topology topology;
  for (const auto& component : system.molecules)
    topology.parts.push_back({read_molecule(component.model), component.count});
  for (TomlTable table : tables) {
    mixing.pairs.push_back(read_pair(table, file));
    if (!system.topology.file.empty()) continue;  // checked when the topology is read
    try {
      check(mixing, topology);
    } catch (const Error& e) {
      throw e.at(table.where("sites"));
    }
  }
}

// Throws, with the place of the key, unless the name or text is a valid scheme.
void check_scheme(const std::string& scheme, std::string_view key, const TomlTable& table) {
  try {
    nested_scheme_of(scheme);
  } catch (const Error& e) {
    throw e.at(table.where(key));
  }
}

// A list of schemes, if the key exists.
void take_schemes(TomlTable& table, std::string_view key, std::vector<std::string>& schemes) {
  take(schemes, table.texts(key));
  table.require(!schemes.empty(), key, "must name at least one scheme");
  for (const std::string& scheme : schemes) check_scheme(scheme, key, table);
}

constexpr auto must_be_accuracy =
    "must be above 0 % and below 100 %: it bounds R, the fluctuation of the total energy over that "
    "of the potential energy";

void read_integrator(TomlTable table, IntegratorSettings& integrator) {
  integrator.scheme_given = table.has("scheme");
  take(integrator.scheme, table.text("scheme"));
  table.require(!integrator.scheme.empty(), "scheme", "must name a scheme, for example \"hoa2\"");
  check_scheme(integrator.scheme, "scheme", table);
  take_time(table, "step", integrator.step, "2 fs");
  table.require(integrator.step > 0, "step", "must be longer than 0 fs: time goes on in steps");
  integrator.accuracy = table.quantity("accuracy", Dimension::fraction, "0.5 %");
  table.require(integrator.accuracy.value_or(0.5) > 0 && integrator.accuracy.value_or(0.5) < 1,
                "accuracy", must_be_accuracy);
  table.require(!integrator.accuracy || !table.has("step"), "accuracy",
                "stands beside a step, which it is to choose; leave one out");
  take_schemes(table, "candidates", integrator.candidates);
  integrator.lambda_given = table.has("lambda");
  if (integrator.lambda_given) integrator.lambda_place = table.where("lambda");
  take(integrator.lambda, table.number("lambda"));
  table.require(integrator.lambda > 0 && integrator.lambda <= 1, "lambda",
                "must be above 0 and not above 1, the scale of a finite difference");
  table.refuse_unknown();
}

void take_configurational_sample(TomlTable& table, double& interval) {
  take_time(table, "configurational_sample", interval, "20 fs");
  table.require(interval >= 0, "configurational_sample",
                "must be 0 fs or longer; 0 fs measures no configurational temperature");
}

constexpr double longest = 1e12;  // of what is done in pieces [ps]
constexpr auto must_be_time = "must be 0 ps or longer, and 1e6 us (one second) at most";

void read_run(TomlTable table, RunSettings& run) {
  take_time(table, "equilibrate", run.equilibrate, "5 ps");
  table.require(run.equilibrate >= 0 && run.equilibrate <= longest, "equilibrate", must_be_time);
  take_time(table, "length", run.length, "15 ps");
  table.require(run.length > 0, "length", "must be longer than 0 ps");
  take_time(table, "sample", run.sample, "4 fs");
  table.require(run.sample > 0, "sample", "must be longer than 0 fs");
  run.shadow_sample = table.quantity("shadow_sample", Dimension::time, "100 fs");
  table.require(run.shadow_sample.value_or(0) >= 0, "shadow_sample",
                "must be 0 fs or longer; 0 fs measures no shadow energy");
  take_configurational_sample(table, run.configurational_sample);
  table.refuse_unknown();
}

void read_output(TomlTable table, OutputSettings& output) {
  take(output.prefix, table.text("prefix"));
  table.require(!output.prefix.empty(), "prefix", "must not be empty; output files begin with it");
  take_time(table, "trajectory_every", output.trajectory_every, "0.1 ps");
  table.require(output.trajectory_every >= 0, "trajectory_every",
                "must be 0 ps or longer; 0 ps writes no trajectory");
  take(output.formats, table.texts("formats"));
  std::vector<std::string> known;
  for (const std::string_view format : writable_formats()) known.emplace_back(format);
  for (const std::string& format : output.formats)
    table.require(std::find(known.begin(), known.end(), format) != known.end(), "formats",
                  fmt::format("has the unknown format '{}'{}; there are: {}", format,
                              did_you_mean(format, known), join_names(known)));
  take(output.massless_sites, table.boolean("massless_sites"));
  take(output.velocities, table.boolean("velocities"));
  output.plot = one_of(table, "plot", output.plot, {"svg", "png", "none"});
  take(output.checkpoint_every, table.quantity("checkpoint_every", Dimension::wall_clock));
  table.require(output.checkpoint_every > 0, "checkpoint_every", "must be longer than 0 s");
  table.refuse_unknown();
}

void read_study(TomlTable table, StudySettings& study) {
  take_schemes(table, "schemes", study.schemes);
  for (const std::string& text : table.texts("steps").value_or(std::vector<std::string>{})) {
    try {
      study.steps.push_back(quantity(text, Dimension::time, "steps", "2 fs"));
    } catch (const Error& e) {
      throw e.at(table.where("steps"));
    }
    table.require(study.steps.back() > 0, "steps", "must be longer than 0 fs, each of them");
  }
  const auto runs = table.integer("runs").value_or(study.runs);
  table.require(runs >= 2 && runs <= 1'000'000, "runs",
                "must be 2 or more, for an error bar, and not above a million");
  study.runs = static_cast<int>(runs);
  take_time(table, "length", study.length, "15 ps");
  table.require(study.length > 0, "length", "must be longer than 0 ps");
  take_time(table, "decorrelate", study.decorrelate, "2 ps");
  table.require(study.decorrelate >= 0 && study.decorrelate <= longest, "decorrelate",
                must_be_time);
  take_configurational_sample(table, study.configurational_sample);
  table.refuse_unknown();
}

}  // namespace

Config parse_config(std::string_view text, const std::string& file) {
  const toml::table document = parse_toml(text, file);
  TomlTable table(document, file);
  Config config;
  config.source = file;
  config.text = text;
  auto system = table.table("system");
  auto forces = table.table("forces");
  auto pairs = table.tables("pair");
  auto integrator = table.table("integrator");
  auto run = table.table("run");
  auto output = table.table("output");
  auto study = table.table("study");
  table.refuse_unknown();
  if (!system)
    throw Error(
        "there is no table [system], which says what is simulated; begin with [system], "
        "molecules = [{ model = \"tip4p\", count = 512 }], density = \"1 g/cm3\"",
        file);
  read_system(*system, path(file).parent_path(), config.system);
  config.cutoff_place = file;
  if (forces) {
    config.mixing_given = forces->has("mixing");
    const std::string& topology = config.system.topology.file;
    forces->require(!config.mixing_given || topology.empty() || is_data_file(topology), "mixing",
                    "stands beside a GROMACS topology, which tells the rule; leave it out");
    read_forces(*forces, config.forces);
    config.cutoff_place = forces->where("cutoff");
  }
  if (pairs) read_pairs(*pairs, config.system, file, config.forces.mixing);
  if (integrator) read_integrator(*integrator, config.integrator);
  if (run) read_run(*run, config.run);
  if (output) read_output(*output, config.output);
  if (study) read_study(*study, config.study);
  set_precision(config, config.forces.precision);
  return config;
}

void set_precision(Config& config, Precision precision) {
  config.forces.precision = precision;
  IntegratorSettings& integrator = config.integrator;
  if (!integrator.lambda_given) integrator.lambda = precision == Precision::mixed ? 1 : 1e-4;
  if (precision == Precision::mixed && integrator.lambda < min_lambda_in_mixed)
    throw Error(
        fmt::format("lambda = {:g} is below {:g}, the least in mixed precision: forces rounded to "
                    "float enter a finite-difference gradient divided by lambda; leave it out, "
                    "which means 1, or take precision = \"double\"",
                    integrator.lambda, min_lambda_in_mixed),
        integrator.lambda_place);
}

Config read_config(const std::string& file) {
  check_name("the run file", file);
  return parse_config(file_text(file), file);
}

Config default_config() {
  return parse_config(embedded_text("runs/default.toml").value(), "default");
}

}  // namespace polhode
