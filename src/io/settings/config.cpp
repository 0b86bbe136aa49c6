// SPDX-License-Identifier: MIT
#include "polhode/io/settings/config.hpp"

#include <fmt/core.h>

#include <filesystem>
#include <map>
#include <sstream>
#include <string_view>

#include "base/printable.hpp"
#include "io/files/embedded.hpp"
#include "io/files/text_file.hpp"
#include "io/settings/config_parts.hpp"
#include "io/settings/scheme_labels.hpp"
#include "io/settings/settings.hpp"
#include "list_tables.hpp"
#include "polhode/base/error.hpp"
#include "setting_rows.hpp"
#include "toml_table.hpp"

namespace polhode {

namespace {

Config read_document(TomlTable document, const std::string& file) {
  Config config;
  config.source = file;
  std::map<std::string_view, TomlTable> tables;
  for (const SettingTable& rows : setting_tables())
    if (auto table = document.table(rows.name)) tables.emplace(rows.name, std::move(*table));
  const auto pairs = document.tables("pair"), shapes = document.tables("shape");
  const auto schemes = document.table("schemes");
  document.refuse_unknown();
  if (!tables.contains("system"))
    throw Error(
        "there is no table [system]; a run file needs this table to describe the molecules: write "
        "for example [system], molecules = [{ model = \"tip4p\", count = 512 }], density = \"1 "
        "g/cm3\"",
        file);
  if (schemes) config.schemes = read_schemes(*schemes);
  for (const SettingTable& rows : setting_tables()) {
    if (const auto table = tables.find(rows.name); table != tables.end())
      read_table(table->second, rows, config);
    if (rows.name == "system" && shapes) read_shapes(*shapes, config.system.topology);
    if (rows.name == "forces" && pairs) read_pairs(*pairs, config);
  }
  config.ensemble.temperature = config.system.temperature;
  if (const std::string wrong = wrong_temperature(config); !wrong.empty())
    tables.at("system").refuse("temperature", wrong);
  set_precision(config, config.forces.precision);
  return config;
}

/// The kind of run file that refers to files with a given extension. The result is empty if run
/// files may have this extension.
std::string_view kind_of_input(const std::string& file) {
  const std::string extension = std::filesystem::path(file).extension();
  for (const std::string_view one : {".top", ".itp", ".gro", ".mdp", ".tpr"})
    if (extension == one) return "gromacs";
  return is_data_file(file) ? "lammps" : "";
}

}  // namespace

Config parse_config(std::string_view text, const std::string& file, const Overlay& overlay) {
  toml::table document = parse_toml(text, file);
  std::vector<std::string> notes = apply(overlay, document);
  Config config = read_document(TomlTable(document, file, "", &overlay), file);
  config.text = text;
  config.notes = std::move(notes);
  return config;
}

OwnSchemes read_schemes(TomlTable table) {
  OwnSchemes own;
  for (const std::string& name : table.keys()) {
    const std::string text = name + ": " + *table.text(name);
    table.at(name, [&] { single_scheme_of(text); });
    own.emplace(name, text);
  }
  return own;
}

std::string with_own_schemes(const std::string& text, const OwnSchemes& own) {
  const bool definitions = text.find(';') != std::string::npos;  // definitions may contain slashes
  if (own.empty() || definitions) return text;
  std::istringstream words(text);
  std::string result, before = "/";
  for (std::string word; words >> word; before = word) {
    const auto scheme = before == "/" ? own.find(word) : own.end();
    result += (result.empty() ? "" : " ") + (scheme == own.end() ? word : scheme->second);
  }
  return result;
}

std::string wrong_temperature(const Config& config) {
  const EnsembleSettings& ensemble = config.ensemble;
  if (config.system.temperature > 0) return "";
  if (ensemble.hybrid_monte_carlo || ensemble.barostat)
    return fmt::format(
        "must be above 0 K: at 0 K {} only accepts moves to lower energies; to reach an energy "
        "minimum, use a [thermostat] at 0 K instead",
        ensemble.hybrid_monte_carlo ? "hybrid Monte Carlo" : "a barostat");
  if (ensemble.thermostat) return "";
  return "must be above 0 K; 0 K is only possible with a [thermostat], which then cools the system";
}

void set_precision(Config& config, Precision precision) {
  config.forces.precision = precision;
  IntegratorSettings& integrator = config.integrator;
  if (!config.gives("integrator.lambda"))
    integrator.lambda =
        precision == Precision::mixed ? lambda_in_mixed : IntegratorSettings{}.lambda;
  if (precision == Precision::mixed && integrator.lambda < min_lambda_in_mixed)
    throw Error(fmt::format("lambda = {:g} is below {:g}, the minimum in mixed precision, since a "
                            "small lambda amplifies the rounding error of the forces; leave lambda "
                            "out (default: {:g}), or use precision = \"double\"",
                            integrator.lambda, min_lambda_in_mixed, lambda_in_mixed),
                config.place("integrator.lambda"));
}

Config read_config(const std::string& file, const Overlay& overlay) {
  check_name("the run file", file);
  const std::string text = file_text(file);
  if (const std::string_view kind = kind_of_input(file); !kind.empty())
    throw Error(
        fmt::format("this is an input file of another program; give a run file (TOML) that "
                    "contains the path of this file: 'polhode new {}' writes such a run file",
                    kind),
        file);
  return parse_config(text, file, overlay);
}

Config default_config(const Overlay& overlay) {
  return parse_config(embedded_text("runs/default.toml").value(), "default", overlay);
}

}  // namespace polhode
