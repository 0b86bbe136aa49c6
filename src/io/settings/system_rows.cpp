// SPDX-License-Identifier: MIT
// The settings of the table [system], and the tables [[shape]].
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>

#include "io/files/embedded.hpp"
#include "io/files/text_file.hpp"
#include "io/formats/format.hpp"
#include "list_tables.hpp"
#include "polhode/base/error.hpp"
#include "polhode/io/topology/molecule_file.hpp"
#include "setting_rows.hpp"

namespace polhode {
namespace {

using std::filesystem::path;

std::string resolve(const path& folder, const std::string& name) {
  return (folder / name).lexically_normal().string();
}

/// Reads a molecule, which is given by the name of a model, by the path of a molecule file, or as a
/// table.
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
  table.at("model", [&] { read_molecule(component.model); });
}

SystemSettings::Component read_component(TomlTable table, const path& folder,
                                         const std::string& file, bool from_file) {
  SystemSettings::Component component;
  read_model(table, folder, file, component);
  const auto count = table.integer("count");
  table.refuse_unknown();
  if (!count && !from_file)
    table.refuse("count",
                 "a molecule has no count, and there is no initial configuration that determines "
                 "the count; write for example count = 512");
  table.require(count.value_or(0) >= (from_file ? 0 : 1), "count",
                from_file ? "must be 0 or more; 0 means the number in the initial configuration"
                          : "must be 1 or more");
  component.count = static_cast<std::size_t>(count.value_or(0));
  return component;
}

/// Reads the box, given by one edge length or by three.
void read_box(TomlTable& table, const SettingRow& row, Config& config) {
  if (!table.has(row.key)) return;
  Vec3<double>& box = config.system.box.emplace();
  if (table.holds_list(row.key)) {
    const auto edges = table.texts(row.key);
    table.require(edges->size() == 3, row.key, "must be one edge or a list of three");
    for (std::size_t k = 0; k < 3; ++k)
      box[k] = table.at(row.key, [&] {
        return quantity((*edges)[k], Dimension::length, fmt::format("box[{}]", k),
                        row.unit.example);
      });
  } else {
    const double edge = *table.quantity(row.key, Dimension::length, row.unit.example);
    box = {edge, edge, edge};
  }
  table.require(is_valid(row, std::min({box.x, box.y, box.z})), row.key, complaint(row));
}

void check_extent(const TomlTable& table, const SystemSettings& system) {
  if (system.density && system.box)
    table.refuse("density",
                 "cannot be combined with a box, since the box already determines the density; "
                 "leave one of the two out");
  if (!system.initial_configuration.empty() && (system.density || system.box))
    table.refuse(system.box ? "box" : "density",
                 "cannot be combined with an initial configuration, since the configuration has "
                 "its own box; leave one of the two out");
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
  table.at("initial_configuration", [&] { format_of(file); });
  system.initial_configuration = std::move(file);
}

path folder_of(const Config& config) { return path(config.source).parent_path(); }

void read_checkpoint_key(TomlTable& table, const SettingRow& row, Config& config) {
  SystemSettings& system = config.system;
  read_row(table, row, config);
  if (system.checkpoint.empty()) return;
  table.require(
      !system.initial_configuration.empty(), row.key,
      "contains the full-precision state of an initial configuration, but there is no initial "
      "configuration; write for example initial_configuration = \"water-prepared.gro\"");
  system.checkpoint = resolve(folder_of(config), system.checkpoint);
  table.require(is_file(system.checkpoint), row.key,
                fmt::format("is not a file: '{}' does not exist", system.checkpoint));
}

void read_velocities(TomlTable& table, const SettingRow& row, Config& config) {
  SystemSettings& system = config.system;
  const auto velocities = table.text(row.key);
  if (!velocities) return;
  table.require(*velocities == "new" || *velocities == "from file", row.key,
                "must be \"from file\" or \"new\"");
  table.require(*velocities == "new" || !system.initial_configuration.empty(), row.key,
                "cannot come from a file, since there is no initial configuration; leave it out");
  system.new_velocities = *velocities == "new";
}

// A macro has the form "NAME" or "NAME=VALUE", where NAME must be valid in #ifdef.
bool is_macro(std::string_view text) {
  const std::string_view name = text.substr(0, text.find('='));
  return !name.empty() && name.front() != '-' && name.find_first_of(" \t") == name.npos;
}

// Reads the topology file. A LAMMPS data file is both topology and initial configuration.
void read_topology_file(TomlTable& table, const path& folder, SystemSettings& system) {
  TopologySettings& topology = system.topology;
  topology.file = table.text("topology").value_or("");
  const bool given = !topology.file.empty();
  if (given) {
    topology.file = resolve(folder, topology.file);
    table.require(!table.has("molecules"), "topology",
                  "cannot be combined with molecules, since the topology defines the molecules; "
                  "leave one of the two out");
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
}

/// Reads the keys that apply only to GROMACS topologies; their values are lists of texts.
void read_topology_list(TomlTable& table, const SettingRow& row, Config& config) {
  const std::string& file = config.system.topology.file;
  const bool gromacs = table.has("topology") && !file.empty() && !is_data_file(file);
  table.require(gromacs || !table.has(row.key), row.key,
                "has no meaning without a GROMACS topology; leave it out");
  read_row(table, row, config);
}

void read_include(TomlTable& table, const SettingRow& row, Config& config) {
  read_topology_list(table, row, config);
  for (std::string& name : config.system.topology.include) name = resolve(folder_of(config), name);
}

void read_define(TomlTable& table, const SettingRow& row, Config& config) {
  read_topology_list(table, row, config);
  for (const std::string& macro : config.system.topology.define)
    table.require(is_macro(macro), row.key,
                  fmt::format("has '{}', which is not a macro name; write names, \"NAME\" or "
                              "\"NAME=VALUE\", without -D",
                              macro));
}

void read_molecules(TomlTable& table, Config& config) {
  SystemSettings& system = config.system;
  const auto components = table.tables("molecules");
  if (!components || components->empty())
    table.refuse("",
                 "there are no molecules; write for example "
                 "molecules = [{ model = \"tip4p\", count = 512 }]");
  for (const TomlTable& component : *components)
    system.molecules.push_back(read_component(component, folder_of(config), config.source,
                                              !system.initial_configuration.empty()));
  const auto open = [](const auto& component) { return component.count == 0; };
  if (system.molecules.size() > 1 &&
      std::any_of(system.molecules.begin(), system.molecules.end(), open))
    table.refuse("molecules",
                 "has several models, one of them without a count; the initial configuration "
                 "determines the count only if there is a single model");
}

/// Reads initial configuration, topology and molecules.
void read_contents(TomlTable& table, Config& config) {
  const path folder = folder_of(config);
  read_start(table, folder, config.system);
  read_topology_file(table, folder, config.system);
  if (config.system.topology.file.empty()) read_molecules(table, config);
}

/// A setting of the table [system] for topology files.
template <class Member>
SettingMember topology(Member TopologySettings::*one) {
  return member([one](Config& c) { return &(c.system.topology.*one); });
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
                   "a shape requires a GROMACS topology, but there is none; leave the shape out, "
                   "since models define the shapes of all other molecules");
    if (!molecule || !positions || positions->empty())
      table.refuse("",
                   "a shape needs a molecule and its positions; write for example "
                   "molecule = \"CO2\", positions = [\"0 0 0 nm\", \"0.116 0 0 nm\"]");
    Shape shape;
    for (const std::string& position : *positions)
      shape.push_back(table.at(
          "positions", [&] { return vector_quantity(position, Dimension::length, "positions"); }));
    if (!topology.shapes.emplace(*molecule, std::move(shape)).second)
      table.refuse("molecule", "has two shapes; delete one of them");
  }
}

SettingTable system_table() {
  using S = SystemSettings;
  const auto system = in(&Config::system);
  return {
      "system",
      {row("molecules",
           "molecules of the system, in the order of the atoms of the initial configuration",
           More{.domain = "list of `{ model, count }`",
                .fallback = "required",
                .read = read_by_table,
                .kinds = {SettingKind::tables}}),
       row("topology", topology(&TopologySettings::file),
           "path of a [GROMACS](gromacs.md) topology or a [LAMMPS](lammps.md) data file, which "
           "replaces `molecules`",
           More{.read = read_by_table, .free = true}),
       row("include", topology(&TopologySettings::include),
           "folders that are searched for the files of a [GROMACS topology](gromacs.md)",
           More{.read = read_include, .free = true}),
       row("define", topology(&TopologySettings::define),
           "macros of a [GROMACS topology](gromacs.md), `\"NAME\"` or `\"NAME=VALUE\"`",
           More{.read = read_define, .free = true}),
       row("rigid", topology(&TopologySettings::rigid),
           "flexible molecule types of a [GROMACS topology](gromacs.md) that are made rigid",
           More{.read = read_topology_list, .free = true}),
       row("initial_configuration", system(&S::initial_configuration),
           "initial configuration and its box: `\"w512\"`, or the path of a file in any "
           "[format](formats.md) with atom names. Velocities in the file are used after removal of "
           "the [motion of the centre of mass](../theory.md#the-centre-of-mass)",
           More{.fallback = "lattice", .read = read_by_table, .free = true}),
       row("checkpoint", system(&S::checkpoint),
           "path of a [checkpoint](checkpoints.md), written by [prepare](prepare.md), that "
           "contains the initial state to the last bit",
           More{.read = read_checkpoint_key, .free = true}),
       row("density", system(&S::density), SettingUnit{Dimension::density, "g/cm3", "1 g/cm3"},
           above_to(0, 22.6,
                    ", the density of osmium, the densest element; is your density in kg/m3? Water "
                    "has 1 g/cm3"),
           "density of the initial lattice in a cubic box; cannot be combined with `box` or "
           "`initial_configuration`",
           More{.free = true}),
       row("box", SettingUnit{Dimension::length, "nm", "2.5 nm"}, above(0),
           "box edges of the initial lattice; cannot be combined with `density`",
           More{.domain = "length, or list of three, > 0",
                .read = read_box,
                .kinds = {SettingKind::quantity, SettingKind::texts}}),
       row("velocities",
           "`\"new\"` draws momenta at `temperature` with `seed` even if the initial configuration "
           "contains velocities",
           More{.domain = "`\"from file\"`, `\"new\"`",
                .fallback = "`\"from file\"` if the file contains velocities",
                .read = read_velocities}),
       row("temperature", system(&S::temperature), SettingUnit{Dimension::temperature, "K"},
           from(0),
           "temperature for drawing momenta, for equilibration and for the thermostat; 0 K "
           "requires a thermostat"),
       row("seed", system(&S::seed), from(0),
           "random seed for the lattice (positions, orientations) and for drawn momenta")},
      read_contents,
      [](TomlTable& table, Config& config) { check_extent(table, config.system); }};
}

}  // namespace polhode
