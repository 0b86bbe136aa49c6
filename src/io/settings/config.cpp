// SPDX-License-Identifier: MIT
#include "polhode/io/settings/config.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>

#include "base/printable.hpp"
#include "base/suggest.hpp"
#include "config_tables.hpp"
#include "io/files/embedded.hpp"
#include "io/files/text_file.hpp"
#include "io/settings/setting_keys.hpp"
#include "polhode/base/error.hpp"
#include "toml_table.hpp"

namespace polhode {

std::string one_of(TomlTable& table, std::string_view key, std::string_view fallback,
                   std::span<const std::string_view> names) {
  std::string value = table.text(key).value_or(std::string(fallback));
  if (std::find(names.begin(), names.end(), value) == names.end())
    table.refuse(key, must_be_one_of(names, value));
  return value;
}

namespace {

Config read_document(TomlTable table, const std::string& file) {
  Config config;
  config.source = file;
  auto system = table.table("system");
  auto forces = table.table("forces");
  auto pairs = table.tables("pair");
  auto shapes = table.tables("shape");
  auto schemes = table.table("schemes");
  auto integrator = table.table("integrator");
  auto run = table.table("run");
  auto prepare = table.table("prepare");
  auto output = table.table("output");
  auto study = table.table("study");
  auto thermostat = table.table("thermostat");
  auto barostat = table.table("barostat");
  auto hybrid = table.table("hybrid_monte_carlo");
  table.refuse_unknown();
  if (!system)
    throw Error(
        "there is no table [system], which describes the molecules; write for example [system], "
        "molecules = [{ model = \"tip4p\", count = 512 }], density = \"1 g/cm3\"",
        file);
  read_system(*system, file, config.system);
  if (shapes) read_shapes(*shapes, config.system.topology);
  config.cutoff_place = file;
  if (forces) {
    config.mixing_given = forces->has("mixing");
    const std::string& topology = config.system.topology.file;
    forces->require(
        !config.mixing_given || topology.empty() || is_data_file(topology), "mixing",
        "cannot be combined with a GROMACS topology, which has its own mixing rule; leave it out");
    read_forces(*forces, config.forces);
    config.cutoff_place = forces->where("cutoff");
  }
  if (pairs) read_pairs(*pairs, config.system, file, config.forces.mixing);
  if (schemes) config.schemes = read_schemes(*schemes);
  if (integrator) read_integrator(*integrator, config.integrator, config.schemes);
  if (run) read_run(*run, config.run);
  if (prepare) read_preparation(*prepare, config.prepare);
  if (output) read_output(*output, config.output);
  if (study) read_study(*study, config.study, config.schemes);
  EnsembleSettings& ensemble = config.ensemble;
  ensemble.temperature = config.system.temperature;
  if (thermostat) ensemble.thermostat = read_thermostat(*thermostat);
  if (barostat) {
    config.compressibility_given = barostat->has("compressibility");
    ensemble.barostat = read_barostat(*barostat);
  }
  if (hybrid) ensemble.hybrid_monte_carlo = read_hybrid_monte_carlo(*hybrid);
  if (const std::string wrong = wrong_temperature(config); !wrong.empty())
    system->refuse("temperature", wrong);
  set_precision(config, config.forces.precision);
  return config;
}

}  // namespace

Config parse_config(std::string_view text, const std::string& file) {
  const toml::table document = parse_toml(text, file);
  Config config = read_document(TomlTable(document, file), file);
  config.text = text;
  return config;
}

// A run file with each table and the keys that must be there: readers ask for all others.
std::vector<SettingKey> setting_keys() {
  constexpr std::string_view text = R"(
    system.molecules = [{ model = "argon", count = 1 }]
    system.box = "3 nm"
    forces = {}
    integrator = {}
    run = {}
    prepare = {}
    output = {}
    study = {}
    thermostat = {}
    barostat.pressure = "1 bar"
    hybrid_monte_carlo = {})";
  const toml::table document = parse_toml(text, "keys");
  std::vector<SettingKey> keys;
  read_document(TomlTable(document, "keys", "", &keys), "keys");
  return keys;
}

std::string wrong_temperature(const Config& config) {
  const EnsembleSettings& ensemble = config.ensemble;
  if (config.system.temperature > 0) return "";
  if (ensemble.hybrid_monte_carlo || ensemble.barostat)
    return fmt::format(
        "must be above 0 K: at 0 K {} accepts only moves to lower energies, so it "
        "samples nothing; to reach an energy minimum, leave it out and use a "
        "[thermostat] at 0 K",
        ensemble.hybrid_monte_carlo ? "hybrid Monte Carlo" : "a barostat");
  if (ensemble.thermostat) return "";
  return "must be above 0 K; 0 K has a meaning with a [thermostat] only, which then cools";
}

void set_precision(Config& config, Precision precision) {
  config.forces.precision = precision;
  IntegratorSettings& integrator = config.integrator;
  if (!integrator.lambda_given)
    integrator.lambda =
        precision == Precision::mixed ? lambda_in_mixed : IntegratorSettings{}.lambda;
  if (precision == Precision::mixed && integrator.lambda < min_lambda_in_mixed)
    throw Error(
        fmt::format("lambda = {:g} is below {:g}, the minimum in mixed precision, because the "
                    "rounding error of the forces is divided by lambda in a finite-difference "
                    "gradient; leave it out (default: {:g}), or use precision = \"double\"",
                    integrator.lambda, min_lambda_in_mixed, lambda_in_mixed),
        integrator.lambda_place);
}

namespace {

/// The kind of run file that names files with this extension; none if run files may have it.
std::string_view kind_of_input(const std::string& file) {
  const std::string extension = std::filesystem::path(file).extension();
  for (const std::string_view one : {".top", ".itp", ".gro", ".mdp", ".tpr"})
    if (extension == one) return "gromacs";
  return is_data_file(file) ? "lammps" : "";
}

}  // namespace

Config read_config(const std::string& file) {
  check_name("the run file", file);
  const std::string text = file_text(file);
  if (const std::string_view kind = kind_of_input(file); !kind.empty())
    throw Error(
        fmt::format("this is an input file of another program, not a run file, which is TOML and "
                    "names it; 'polhode new {}' writes one to start from",
                    kind),
        file);
  return parse_config(text, file);
}

Config default_config() {
  return parse_config(embedded_text("runs/default.toml").value(), "default");
}

}  // namespace polhode
