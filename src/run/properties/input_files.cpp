// SPDX-License-Identifier: MIT
#include "run/properties/input_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <optional>
#include <string_view>

#include "base/printable.hpp"
#include "io/settings/run_file_template.hpp"
#include "io/topology/gromacs_mdp.hpp"
#include "polhode/base/error.hpp"
#include "polhode/io/topology/topology_file.hpp"
#include "polhode/run/simulation/system/system.hpp"
#include "run/properties/property.hpp"

namespace polhode {
namespace {

constexpr double usual_temperature = 298.15;  // [K]

std::string extension_of(const std::string& word) {
  return std::filesystem::path(word).extension().string();
}

/// Removes the first word and returns it, if it is the name of a file; errors of properties, such
/// as "0.1 %", begin with a digit or a point.
std::optional<std::string> take_file(std::vector<std::string>& words) {
  if (words.empty() || words.front().empty()) return std::nullopt;
  std::string first = words.front();
  const std::string extension = extension_of(first);
  const bool is_file =
      extension.size() > 1 && std::isalpha(static_cast<unsigned char>(extension[1]));
  if (!is_file) return std::nullopt;
  words.erase(words.begin());
  return first;
}

/// Whether a parameter of GROMACS concerns forces: the thermostat and the output of the run do not
/// matter here.
bool concerns_forces(std::string_view parameter) {
  std::string name;
  for (const char c : parameter.substr(0, parameter.find('=')))
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  constexpr std::array beginnings = {"vdw",     "rvdw",  "coulomb", "rcoulomb", "dispcorr",
                                     "epsilon", "ewald", "lj",      "define",   "include"};
  return std::ranges::any_of(beginnings,
                             [&](const char* beginning) { return name.starts_with(beginning); });
}

Config config_of_mdp(const std::string& mdp, const MdpFiles& files,
                     std::vector<std::string>& notes) {
  const MdpImport read = read_mdp(mdp, files);
  for (const auto& [parameter, reason] : read.differences)
    if (concerns_forces(parameter))
      notes.push_back(fmt::format("note: {}: {}", printable(parameter), reason));
  // Paths are relative to the current folder, as in GROMACS.
  return parse_config(read.run_file, std::filesystem::path(mdp).filename().string());
}

/// The settings of a run file template with other files.
Config config_of_template(const char* kind, const Overlay& files, const std::string& system,
                          std::vector<std::string>& notes) {
  std::string text = run_file_template(kind);
  Config config = parse_config(text, "measure", files);
  const bool charged = has_charges(build_topology(config.system));
  if (!charged) {  // the default of the truncation depends on the electrostatics
    text.insert(text.find("electrostatics"), "# ");
    config = parse_config(text, "measure", files);
  }
  config.system.temperature = usual_temperature;
  notes.push_back(fmt::format(
      "note: '{}' does not give the forces; they are those of 'polhode new {}': cutoff {:g} nm{}, "
      "with dispersion correction{}; {} sets others",
      printable(system), kind, config.forces.cutoff, charged ? ", PME" : "",
      config.gives("forces.mixing") ? ", geometric mixing" : "",
      config.gives("forces.mixing") ? "a run file" : "an .mdp file or a run file"));
  return config;
}

}  // namespace

bool is_input_file(const std::string& system) {
  return extension_of(system) == ".top" || is_data_file(system);
}

Config config_of_input(const std::string& system, std::vector<std::string>& words,
                       std::vector<std::string>& notes) {
  const std::optional<std::string> first = take_file(words), second = take_file(words);
  if (is_data_file(system)) {
    if (first)
      throw Error(fmt::format("the file '{}' has no meaning with a LAMMPS data file; leave it out",
                              *first));
    return config_of_template("lammps",
                              {.settings = {{"system.initial_configuration", {system}, "SYSTEM"}}},
                              system, notes);
  }
  if (!first || extension_of(*first) == ".mdp")
    throw Error(
        fmt::format("the topology '{}' needs a file with positions; write for example {} conf.gro",
                    system, system));
  if (!second)
    return config_of_template("gromacs",
                              {.settings = {{"system.topology", {system}, "SYSTEM"},
                                            {"system.initial_configuration", {*first}, *first}}},
                              system, notes);
  if (extension_of(*second) != ".mdp")
    throw Error(fmt::format(
        "'{}' is not a file of run parameters of GROMACS; its extension must be .mdp", *second));
  return config_of_mdp(*second, {.topology = system, .coordinates = *first}, notes);
}

}  // namespace polhode
