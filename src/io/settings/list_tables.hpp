// SPDX-License-Identifier: MIT
// The lists of tables of a run file, and the table of own schemes.
#pragma once

#include <vector>

#include "polhode/io/settings/config.hpp"
#include "toml_table.hpp"

namespace polhode {

/// The tables [[shape]] of molecule types of a GROMACS topology.
void read_shapes(const std::vector<TomlTable>& tables, TopologySettings& topology);
/// The tables [[pair]]; the names of sites are checked against the molecules.
void read_pairs(const std::vector<TomlTable>& tables, Config& config);
/// The texts of the schemes in the table [schemes], by name, such as "mine: B(1/2) A(1) B(1/2)".
OwnSchemes read_schemes(TomlTable table);

}  // namespace polhode
