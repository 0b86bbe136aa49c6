// SPDX-License-Identifier: MIT
// Molecule models, and the molecules of files.
#pragma once

#include <string>
#include <vector>

#include "polhode/model/molecule.hpp"
#include "polhode/run/quantities.hpp"

namespace polhode {

/// Finds the molecules to which a name refers. The name may be the name of a model, or the path of
/// a molecule file, a GROMACS topology or a LAMMPS data file. Each molecule is listed once. If the
/// name is empty, all models are listed.
/// @throws Error  if the model does not exist, or a file cannot be read
std::vector<Molecule> find_molecules(const std::string& name);

/// A molecule with its sites: lengths in nm, masses in u, charges in e, energies in kJ/mol.
Quantities quantities(const Molecule& molecule);

/// The sites of molecules as rows of a table.
std::vector<Quantities> records(const std::vector<Molecule>& molecules);

}  // namespace polhode
