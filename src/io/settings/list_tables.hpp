// SPDX-License-Identifier: MIT
// Tables without rows of settings: molecules, the lists of tables of a run file, and schemes.
#pragma once

#include <string>
#include <vector>

#include "polhode/io/settings/config.hpp"
#include "toml_table.hpp"

namespace polhode {

/// Reads a molecule from a table of a molecule file or run file.
/// @param file  file that contains the table; paths of tabulated potentials are relative to this
///   file
/// @throws Error  with file, line and key
Molecule read_molecule_table(TomlTable table, const std::string& file);
/// Reads the tables [[shape]] with shapes of molecule types of a GROMACS topology.
void read_shapes(const std::vector<TomlTable>& tables, TopologySettings& topology);
/// Reads the tables [[pair]]; the names of sites are checked against the molecules.
void read_pairs(const std::vector<TomlTable>& tables, Config& config);
/// Reads the table [schemes]: texts of schemes such as "mine: B(1/2) A(1) B(1/2)", by name.
OwnSchemes read_schemes(TomlTable table);

}  // namespace polhode
