// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "config_tables.hpp"
#include "io/files/embedded.hpp"
#include "io/formats/format.hpp"
#include "molecule_table.hpp"
#include "polhode/base/error.hpp"
#include "polhode/io/topology/molecule_file.hpp"

namespace polhode {
namespace {

using std::filesystem::path;

std::string resolve(const path& folder, const std::string& name) {
  return (folder / name).lexically_normal().string();
}

/// False also for a name that the system refuses, as one that is too long.
bool is_file(const std::string& name) {
  std::error_code refused;
  return std::filesystem::is_regular_file(name, refused);
}

/// A model's name, the path of a molecule file, or the molecule itself as a table.
void read_model(TomlTable& table, const path& folder, const std::string& file,
                SystemSettings::Component& component) {
  if (table.has("model") && !table.holds_text("model")) {
    component.own = read_molecule_table(*table.table("model"), file);
    component.model = component.own->name;
    return;
  }
  const auto model = table.text("model");
  if (!model) table.refuse("model", "a molecule has no model; write for example model = \"tip4p\"");
  component.model = is_molecule_path(*model) ? resolve(folder, *model) : *model;
  try {
    read_molecule(component.model);
  } catch (const Error& e) {
    throw e.at(table.where("model"));
  }
}

SystemSettings::Component read_component(TomlTable table, const path& folder,
                                         const std::string& file, bool from_file) {
  SystemSettings::Component component;
  read_model(table, folder, file, component);
  const auto count = table.integer("count");
  table.refuse_unknown();
  if (!count && !from_file)
    table.refuse("count",
                 "a molecule has no count and there is no initial configuration from which to "
                 "count; write for example count = 512");
  table.require(count.value_or(0) >= (from_file ? 0 : 1), "count",
                from_file ? "must be 0 or more; 0 means as many as the initial configuration has"
                          : "must be 1 or more");
  component.count = static_cast<std::size_t>(count.value_or(0));
  return component;
}

Vec3<double> read_box(TomlTable& table) {
  if (!table.holds_list("box")) {
    const double edge = *table.quantity("box", Dimension::length, "2.5 nm");
    return {edge, edge, edge};
  }
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
  const double osmium = 22.6;  // [g/cm3], the densest element
  table.require(
      system.density.value_or(1) <= osmium * unit("g/cm3", Dimension::density), "density",
      fmt::format("is more than {:g} g/cm3, the density of osmium, the densest element; is it in "
                  "kg/m3? Water has 1 g/cm3",
                  osmium));
  if (table.has("box")) system.box = read_box(table);
  if (system.box)
    table.require(std::min({system.box->x, system.box->y, system.box->z}) > 0, "box",
                  "must have edges longer than 0 nm");
  const bool start = !system.initial_configuration.empty();
  if (system.density && system.box)
    table.refuse("density",
                 "cannot be combined with a box, which already fixes the density; leave one out");
  if (start && (system.density || system.box))
    table.refuse(
        system.box ? "box" : "density",
        "cannot be combined with an initial configuration, which has its own box; leave one out");
}

void read_start(TomlTable& table, const path& folder, SystemSettings& system) {
  table.renamed("start", "initial_configuration");
  system.initial_configuration = table.text("initial_configuration").value_or("");
  if (system.initial_configuration.empty()) return;
  if (embedded_text("start/" + system.initial_configuration + ".gro")) return;
  std::string file = resolve(folder, system.initial_configuration);
  table.require(is_file(file), "initial_configuration",
                fmt::format("is neither an embedded initial configuration, such as \"w512\", nor a "
                            "file: '{}' does not exist",
                            file));
  try {
    format_of(file);
  } catch (const Error& e) {
    throw e.at(table.where("initial_configuration"));
  }
  system.initial_configuration = std::move(file);
}

void read_checkpoint_key(TomlTable& table, const path& folder, SystemSettings& system) {
  const auto file = table.text("checkpoint");
  if (!file) return;
  table.require(!system.initial_configuration.empty(), "checkpoint",
                "has the state of an initial configuration at full precision, and there is none; "
                "write for example initial_configuration = \"water-prepared.gro\"");
  system.checkpoint = resolve(folder, *file);
  table.require(is_file(system.checkpoint), "checkpoint",
                fmt::format("is not a file: '{}' does not exist", system.checkpoint));
}

void read_velocities(TomlTable& table, SystemSettings& system) {
  const auto velocities = table.text("velocities");
  if (!velocities) return;
  table.require(*velocities == "new" || *velocities == "from file", "velocities",
                "must be \"from file\" or \"new\"");
  table.require(*velocities == "new" || !system.initial_configuration.empty(), "velocities",
                "cannot come from a file, since there is no initial configuration; leave it out");
  system.new_velocities = *velocities == "new";
}

std::vector<std::string> resolved(const path& folder, std::vector<std::string> names) {
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
                  "cannot be combined with molecules, which it defines itself; leave one out");
    table.require(is_file(topology.file), "topology",
                  fmt::format("is not a file: '{}' does not exist", topology.file));
  } else if (is_data_file(system.initial_configuration) && !table.has("molecules")) {
    topology.file = system.initial_configuration;
  }
  if (given && system.initial_configuration.empty() && is_data_file(topology.file))
    system.initial_configuration = topology.file;
  if (given && system.initial_configuration.empty())
    table.refuse("topology",
                 "needs an initial configuration with its atoms in the same order; write for "
                 "example initial_configuration = \"conf.gro\"");
  const bool gromacs = given && !is_data_file(topology.file);
  for (const char* key : {"include", "define", "rigid"})
    table.require(gromacs || !table.has(key), key,
                  "has no meaning without a GROMACS topology; leave it out");
  take(topology.include, table.texts("include"));
  take(topology.define, table.texts("define"));
  for (const std::string& macro : topology.define)
    table.require(is_macro(macro), "define",
                  fmt::format("has '{}', which is not a macro name; write names, \"NAME\" or "
                              "\"NAME=VALUE\", without -D",
                              macro));
  take(topology.rigid, table.texts("rigid"));
  topology.include = resolved(folder, std::move(topology.include));
}

void read_molecules(TomlTable& table, const path& folder, const std::string& file,
                    SystemSettings& system) {
  const auto components = table.tables("molecules");
  if (!components || components->empty())
    table.refuse("",
                 "there are no molecules; write for example "
                 "molecules = [{ model = \"tip4p\", count = 512 }]");
  for (const TomlTable& component : *components)
    system.molecules.push_back(
        read_component(component, folder, file, !system.initial_configuration.empty()));
  const auto open = [](const auto& component) { return component.count == 0; };
  if (system.molecules.size() > 1 &&
      std::any_of(system.molecules.begin(), system.molecules.end(), open))
    table.refuse("molecules",
                 "has several models, one of them without a count; only a single model can be "
                 "counted in the initial configuration");
}

}  // namespace

Molecule molecule_of(const SystemSettings::Component& component) {
  return component.own ? *component.own : read_molecule(component.model);
}

void read_shapes(const std::vector<TomlTable>& tables, TopologySettings& topology) {
  for (TomlTable table : tables) {
    const auto molecule = table.text("molecule");
    const auto positions = table.texts("positions");
    table.refuse_unknown();
    if (topology.file.empty() || is_data_file(topology.file))
      table.refuse("",
                   "a shape is for a molecule type of a GROMACS topology, and there is none; other "
                   "molecules have theirs in their models; leave it out");
    if (!molecule || !positions || positions->empty())
      table.refuse("",
                   "a shape needs a molecule and its positions; write for example "
                   "molecule = \"CO2\", positions = [\"0 0 0 nm\", \"0.116 0 0 nm\"]");
    Shape shape;
    for (const std::string& position : *positions) try {
        shape.push_back(vector_quantity(position, Dimension::length, "positions"));
      } catch (const Error& e) {
        throw e.at(table.where("positions"));
      }
    if (!topology.shapes.emplace(*molecule, std::move(shape)).second)
      table.refuse("molecule", "has two shapes; leave one out");
  }
}

void read_system(TomlTable table, const std::string& file, SystemSettings& system) {
  const path folder = path(file).parent_path();
  read_start(table, folder, system);
  read_topology_keys(table, folder, system);
  if (system.topology.file.empty()) read_molecules(table, folder, file, system);
  read_extent(table, system);
  system.temperature_given = table.has("temperature");
  system.seed_given = table.has("seed");
  take(system.temperature, table.quantity("temperature", Dimension::temperature));
  table.require(system.temperature >= 0, "temperature", "must be above 0 K");
  const auto seed = table.integer("seed");
  table.require(seed.value_or(0) >= 0, "seed", "must be 0 or more");
  read_checkpoint_key(table, folder, system);
  read_velocities(table, system);
  if (seed) system.seed = static_cast<std::uint64_t>(*seed);
  table.refuse_unknown();
}

}  // namespace polhode
