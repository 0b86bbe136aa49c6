// SPDX-License-Identifier: MIT
// Molecule models, and the molecules of files.
#pragma once

#include <string>
#include <vector>

#include "polhode/model/molecule.hpp"
#include "polhode/run/quantities.hpp"

namespace polhode {

/// The molecules that a name refers to: a model, or those of a molecule file, of a GROMACS topology
/// or of a LAMMPS data file, each once; all models if the name is empty.
/// @throws Error  if there is no such model, or a file cannot be read
std::vector<Molecule> find_molecules(const std::string& name);

/// A molecule with its sites: lengths in nm, masses in u, charges in e, energies in kJ/mol.
Quantities quantities(const Molecule& molecule);

/// The same of each, as rows of a table.
std::vector<Quantities> records(const std::vector<Molecule>& molecules);

}  // namespace polhode
