// SPDX-License-Identifier: MIT
#include "io/settings/prepared_run_file.hpp"

#include <fmt/core.h>

#include <filesystem>
#include <sstream>

#include "io/settings/ensemble_names.hpp"
#include "io/settings/quantity.hpp"
#include "polhode/io/topology/molecule_file.hpp"
#include "toml_table.hpp"

namespace polhode {
namespace {

using std::filesystem::path;

/// Converts relative paths from one base folder to another.
class Rebase {
 public:
  Rebase(const path& from, const path& to)
      : from_(from.empty() ? "." : from), to_(to.empty() ? "." : to) {}

  std::string operator()(const std::string& file) const {
    if (path(file).is_absolute() || from_ == to_) return file;
    return std::filesystem::proximate(from_ / file, to_).string();
  }
  void operator()(toml::table& table, std::string_view key) const {
    if (auto* text = table[key].as_string()) *text = (*this)(text->get());
  }
  void list(toml::table& table, std::string_view key) const {
    if (auto* texts = table[key].as_array())
      for (auto& node : *texts)
        if (auto* text = node.as_string()) *text = (*this)(text->get());
  }

 private:
  path from_, to_;
};

/// Calls visit(table) for each table of a list.
template <class Visit>
void each_table(toml::table& table, std::string_view key, const Visit& visit) {
  if (auto* list = table[key].as_array())
    for (auto& node : *list)
      if (auto* element = node.as_table()) visit(*element);
}

void rewrite_system(toml::table& system, const Config& config, const std::string& coordinates,
                    const std::string& checkpoint, const Rebase& rebase) {
  each_table(system, "molecules", [&](toml::table& molecule) {
    if (is_molecule_path(molecule["model"].value_or(std::string()))) rebase(molecule, "model");
  });
  // A LAMMPS data file may be both topology and initial configuration.
  if (!config.system.topology.file.empty() && !system.contains("topology"))
    system.insert_or_assign("topology", system["initial_configuration"].value_or(std::string()));
  rebase(system, "topology");
  rebase.list(system, "include");
  for (const char* key : {"density", "box", "velocities"}) system.erase(key);
  system.insert_or_assign("initial_configuration", path(coordinates).filename().string());
  system.insert_or_assign("checkpoint", path(checkpoint).filename().string());
  system.insert_or_assign("temperature", fmt::format("{:.12g} K", config.system.temperature));
  system.insert_or_assign("seed", static_cast<std::int64_t>(config.system.seed));
}

/// Writes the output prefix of the preparation, which may differ from the prefix in the run file.
/// Runs from several preparations of the same run file must not use the same prefix.
void write_prefix(toml::table& document, const std::string& prefix) {
  if (!document.contains("output")) document.insert("output", toml::table{});
  if (auto* output = document["output"].as_table()) output->insert_or_assign("prefix", prefix);
}

/// Writes the shapes of molecules to the run file, so that they are derived only once. Shapes
/// derived from the new coordinates would have other principal axes.
void write_shapes(toml::table& document, const std::map<std::string, Shape>& shapes) {
  toml::array tables;
  for (const auto& [molecule, shape] : shapes) {
    toml::array positions;
    for (const Vec3<double>& r : shape)
      positions.push_back(fmt::format("{} {} {} nm", r.x, r.y, r.z));
    tables.push_back(toml::table{{"molecule", molecule}, {"positions", std::move(positions)}});
  }
  if (!shapes.empty()) document.insert_or_assign("shape", std::move(tables));
}

void rewrite_barostat(toml::table& barostat, const Config& config) {
  const BarostatSettings& settings = config.ensemble.barostat.value();
  barostat.insert_or_assign(
      "pressure", fmt::format("{:.12g} bar", settings.pressure / unit("bar", Dimension::pressure)));
  if (!config.gives("barostat.compressibility") &&
      settings.compressibility != default_compressibility())
    barostat.insert_or_assign(
        "compressibility",
        fmt::format("{:.2g} 1/bar",
                    settings.compressibility / unit("1/bar", Dimension::compressibility)));
}

}  // namespace

std::string prepared_run_file(const Config& config, const std::string& coordinates,
                              const std::string& checkpoint, const std::string& run_file) {
  toml::table document = parse_toml(config.text, config.source);
  const Rebase rebase(path(config.source).parent_path(), path(run_file).parent_path());
  if (auto* system = document["system"].as_table())
    rewrite_system(*system, config, coordinates, checkpoint, rebase);
  each_table(document, "pair", [&](toml::table& pair) { rebase(pair, "table"); });
  write_shapes(document, config.system.topology.shapes);
  write_prefix(document, config.output.prefix);
  document.erase("prepare");
  if (auto* run = document["run"].as_table())
    for (const char* key : {"minimise", "equilibrate"}) run->erase(key);
  if (auto* barostat = document["barostat"].as_table()) rewrite_barostat(*barostat, config);
  std::ostringstream text;
  text << document << '\n';
  return text.str();
}

}  // namespace polhode
