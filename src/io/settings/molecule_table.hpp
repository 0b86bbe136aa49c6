// SPDX-License-Identifier: MIT
// A molecule as a table, in a molecule file or within a run file.
#pragma once

#include <string>

#include "polhode/model/molecule.hpp"
#include "toml_table.hpp"

namespace polhode {

/// Reads a molecule from a table.
/// @param file  file that contains the table; paths of tabulated potentials are relative to this
///   file
/// @throws Error  with file, line and key
Molecule read_molecule_table(TomlTable table, const std::string& file);

}  // namespace polhode
