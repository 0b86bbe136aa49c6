// SPDX-License-Identifier: MIT
// Molecule files of LAMMPS, as its command `molecule` reads them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "polhode/base/vec3.hpp"

namespace polhode::lammps {

/// The sites of a molecule file: its sections Coords, Types, Charges and Masses.
struct MoleculeFile {
  std::vector<Vec3<double>> r;
  std::vector<int> types;
  std::vector<double> charges;  ///< 0 if the file has none
  std::vector<double> masses;   ///< empty if the file has none: those of the types
};

/// @param file    its name in errors
/// @throws Error  with the line, if it is not such a file or has no Coords or Types
MoleculeFile parse_molecule_file(std::string_view text, const std::string& file);

}  // namespace polhode::lammps
