// SPDX-License-Identifier: MIT
// Molecule models: one TOML file each, built in or supplied by the user.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "polhode/model/molecule.hpp"

namespace polhode {

/// Reads a molecule: a built-in model by its name, or a user's file by a path that contains a '/'
/// or ends in ".toml".
/// @throws Error  with file, line and key; for an unknown name, with the most similar name
Molecule read_molecule(const std::string& name_or_path);

/// Parses the text of a molecule file; `file` is the file name in error messages.
Molecule parse_molecule(std::string_view text, const std::string& file);

/// Names of all built-in models, in alphabetical order.
std::vector<std::string> molecule_names();

/// Whether a name refers to a user's file rather than a built-in model.
bool is_molecule_path(std::string_view name);

}  // namespace polhode
