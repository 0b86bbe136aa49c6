// SPDX-License-Identifier: MIT
// polhode molecules [NAME]: lists the built-in models, or describes one model.
#include <fmt/core.h>

#include <memory>
#include <string>
#include <vector>

#include "../reports/molecules_report.hpp"
#include "../verbs.hpp"
#include "run/listing/molecules.hpp"

namespace polhode::cli {

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
