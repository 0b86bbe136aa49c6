// SPDX-License-Identifier: MIT
// Commented run files to start from, one for each kind of system.
#pragma once

#include <array>
#include <string_view>

namespace polhode {

/// The kinds: water, at constant energy, temperature or pressure, and a mixture need no other file,
/// the others name files of GROMACS or LAMMPS.
inline constexpr std::array<std::string_view, 6> run_file_kinds = {"water",   "nvt",    "npt",
                                                                   "gromacs", "lammps", "mixture"};

/// The text of the run file of a kind.
/// @throws Error  if there is no such kind
std::string_view run_file_template(std::string_view kind);

}  // namespace polhode
