// SPDX-License-Identifier: MIT
// Molecule models, and the molecules of files.
#pragma once

#include <string>
#include <vector>

#include "polhode/model/molecule.hpp"

namespace polhode {

/// The molecules that a name refers to: a model, or those of a molecule file, of a GROMACS topology
/// or of a LAMMPS data file, each once; all models if the name is empty.
/// @throws Error  if there is no such model, or a file cannot be read
std::vector<Molecule> find_molecules(const std::string& name);

/// The dipole moment [D], 0 where only rounding errors remain of it.
double dipole_in_debye(const Molecule& molecule);
/// A charge [e]; those with few digits sum to zero only up to rounding, which is removed.
double round_charge(double charge);

/// An array, or the one molecule itself if `one`. Lengths in nm, masses in u, charges in e,
/// energies in kJ/mol, the dipole moment in D.
std::string molecules_json(const std::vector<Molecule>& molecules, bool one);

}  // namespace polhode
