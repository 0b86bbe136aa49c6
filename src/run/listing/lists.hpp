// SPDX-License-Identifier: MIT
// Lists to look up: molecule models and the molecules of files, splitting schemes, and the settings
// of run files.
#pragma once

#include <string>
#include <vector>

#include "polhode/integrate/scheme.hpp"
#include "polhode/io/settings/config.hpp"
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

/// Stages, order, cost and source of a scheme.
Quantities quantities(const Scheme& scheme);
/// Stages, order, cost and source of all built-in schemes.
std::vector<Quantities> all_schemes();

/// Settings with values in a run, defaults and meanings.
/// @param name    path or key of a setting, or a table; empty for all settings
/// @param config  configuration whose values are listed; null to list no values
/// @throws Error  if the setting or table does not exist; the message gives the most similar names
std::string settings_text(const std::string& name, const Config* config);

/// Settings with their values, defaults and meanings, as a JSON array.
std::string settings_json(const std::string& name, const Config* config);

}  // namespace polhode
