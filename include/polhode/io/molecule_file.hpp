// SPDX-License-Identifier: MIT
// Molecule models: one TOML file each, within the program or a user's own.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "polhode/model/molecule.hpp"

namespace polhode {

/// A model within the program, by its name, or a user's file, by a path that has a '/' or ends in
/// ".toml".
/// @throws Error  with file, line and key; for an unknown name with the nearest one
Molecule read_molecule(const std::string& name_or_path);

/// The molecule that the text of a molecule file describes; `file` is its name in errors.
Molecule parse_molecule(std::string_view text, const std::string& file);

/// Names of all models within the program, in alphabetic order.
std::vector<std::string> molecule_names();

/// Whether a name means a user's file rather than a model within the program.
bool is_molecule_path(std::string_view name);

}  // namespace polhode
