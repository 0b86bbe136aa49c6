// SPDX-License-Identifier: MIT
// polhode molecules [NAME]: lists the built-in models, or describes one model.
#include <memory>
#include <string>
#include <vector>

#include "../reports/reports.hpp"
#include "../verbs.hpp"
#include "run/listing/lists.hpp"

namespace polhode::cli {

Action molecules_verb(Command& command) {
  struct MoleculesOptions : ResultForm {
    std::string name;
  };
  auto o = std::make_shared<MoleculesOptions>();
  command.add_option(
      "NAME", o->name,
      "a model's name, or the path of a molecule file, a GROMACS topology (.top) or a "
      "LAMMPS data file; default: all");
  command.add_flag("--json", o->json, "print JSON");
  return [o] {
    const std::vector<Molecule> molecules = find_molecules(o->name);
    if (o->name.empty() || (o->json && molecules.size() > 1))
      print_results("molecules", records(molecules), o->json);
    else
      for (const Molecule& molecule : molecules) print_results(quantities(molecule), *o);
    return 0;
  };
}

}  // namespace polhode::cli
