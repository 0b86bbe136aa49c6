// SPDX-License-Identifier: MIT
// Molecules as text and as JSON.
#pragma once

#include <string>
#include <vector>

#include "polhode/model/molecule.hpp"

namespace polhode::cli {

/// A molecule with its sites.
void print_molecule(const Molecule& molecule);
/// A line for each molecule.
void print_molecules(const std::vector<Molecule>& molecules);

}  // namespace polhode::cli
