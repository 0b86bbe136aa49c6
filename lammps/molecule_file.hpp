// SPDX-License-Identifier: MIT
// LAMMPS molecule files, in the format of the command `molecule`.
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
  std::vector<double> charges;  ///< charges; 0 if the file has none
  std::vector<double> masses;   ///< masses; empty if the file has none, so that the masses of the
                                ///< types apply
};

/// Parses the text of a molecule file.
/// @param file    file name in error messages
/// @throws Error  with the line, if it is not a molecule file or has no Coords or Types
MoleculeFile parse_molecule_file(std::string_view text, const std::string& file);

}  // namespace polhode::lammps
