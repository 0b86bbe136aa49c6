// SPDX-License-Identifier: MIT
// polhode molecules [NAME]: lists the built-in models, or describes one model.
#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "molecules_report.hpp"
#include "polhode/io/molecule_file.hpp"
#include "polhode/io/topology_file.hpp"
#include "verbs.hpp"

namespace polhode::cli {
namespace {

// The molecules that a name refers to: a model, or those of a topology file, each
// once; without a name all models.
std::vector<Molecule> find_molecules(const std::string& name) {
  std::vector<Molecule> molecules;
  if (name.empty())
    for (const std::string& model : molecule_names()) molecules.push_back(read_molecule(model));
  if (name.empty()) return molecules;
  if (!name.ends_with(".top") && !is_data_file(name)) return {read_molecule(name)};
  for (const auto& part : read_topology({.file = name}, nullptr).topology.parts)
    if (std::none_of(molecules.begin(), molecules.end(),
                     [&](const Molecule& m) { return m.name == part.molecule.name; }))
      molecules.push_back(part.molecule);
  return molecules;
}

}  // namespace

Action molecules_verb(Command& command) {
  struct Options {
    std::string name;
    bool json = false;
  };
  auto o = std::make_shared<Options>();
  command.add_option(
      "NAME", o->name,
      "a model's name, or the path of a molecule file, a GROMACS topology (.top) or a "
      "LAMMPS data file; default: all");
  command.add_flag("--json", o->json, "print JSON");
  return [o] {
    const std::vector<Molecule> molecules = find_molecules(o->name);
    if (o->json)
      fmt::print("{}\n", molecules_json(molecules, !o->name.empty() && molecules.size() == 1));
    else if (o->name.empty())
      print_molecules(molecules);
    else
      for (const Molecule& molecule : molecules) print_molecule(molecule);
    return 0;
  };
}

}  // namespace polhode::cli
