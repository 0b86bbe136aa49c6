// SPDX-License-Identifier: MIT
// Commented run files to start from, one for each kind of system.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace polhode {

/// The kinds of run files. Run files for a mixture, and for water at constant energy, temperature
/// or pressure, need no other file. The other kinds refer to files of GROMACS or LAMMPS.
inline constexpr std::array<std::string_view, 6> run_file_kinds = {"water",   "nvt",    "npt",
                                                                   "gromacs", "lammps", "mixture"};

/// The ensembles that can be chosen for kinds of run files without a fixed ensemble: constant
/// energy, constant temperature, constant temperature and pressure.
inline constexpr std::array<std::string_view, 3> run_file_ensembles = {"nve", "nvt", "npt"};

/// The text of a run file of a given kind.
/// @param ensemble  one of run_file_ensembles; if empty, the default of the kind
/// @throws Error  if the kind or ensemble does not exist, or if the kind has a different fixed
///   ensemble
std::string run_file_template(std::string_view kind, std::string_view ensemble = {});

}  // namespace polhode
