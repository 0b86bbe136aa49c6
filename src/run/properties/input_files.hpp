// SPDX-License-Identifier: MIT
// Input files of other programs as the system of a measurement.
#pragma once

#include <string>
#include <vector>

#include "polhode/io/settings/config.hpp"

namespace polhode {

/// Whether a system is a topology of GROMACS or a data file of LAMMPS, by its extension.
bool is_input_file(const std::string& system);

/// The settings of a system that files of GROMACS or LAMMPS define. Forces that these files do not
/// give are those of `polhode new gromacs` and `polhode new lammps`.
/// @param words  words after the system. Leading file names, "conf.gro" and "run.mdp", are removed
/// @param notes  receives what the program assumes, and the parameters without counterpart
/// @throws Error  if a file is missing or cannot be read, or a molecule is not rigid
Config config_of_input(const std::string& system, std::vector<std::string>& words,
                       std::vector<std::string>& notes);

}  // namespace polhode
