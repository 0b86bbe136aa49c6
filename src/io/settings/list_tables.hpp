// SPDX-License-Identifier: MIT
// The lists of tables of a run file, and the table of user-defined schemes.
#pragma once

#include <vector>

#include "polhode/io/settings/config.hpp"
#include "toml_table.hpp"

namespace polhode {

/// Reads the tables [[shape]] with shapes of molecule types of a GROMACS topology.
void read_shapes(const std::vector<TomlTable>& tables, TopologySettings& topology);
/// Reads the tables [[pair]]; the names of sites are checked against the molecules.
void read_pairs(const std::vector<TomlTable>& tables, Config& config);
/// Reads the table [schemes]: texts of schemes such as "mine: B(1/2) A(1) B(1/2)", by name.
OwnSchemes read_schemes(TomlTable table);

}  // namespace polhode
