// SPDX-License-Identifier: MIT
// Commented run files to start from, one for each kind of system.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace polhode {

/// The kinds: water, at constant energy, temperature or pressure, and a mixture need no other file,
/// the others name files of GROMACS or LAMMPS.
inline constexpr std::array<std::string_view, 6> run_file_kinds = {"water",   "nvt",    "npt",
                                                                   "gromacs", "lammps", "mixture"};

/// The ensembles of the kinds that have no other: constant energy, constant temperature, constant
/// temperature and pressure.
inline constexpr std::array<std::string_view, 3> run_file_ensembles = {"nve", "nvt", "npt"};

/// The text of the run file of a kind.
/// @param ensemble  empty: that of the kind; otherwise one of run_file_ensembles
/// @throws Error  if there is no such kind or ensemble, or the kind has another ensemble
std::string run_file_template(std::string_view kind, std::string_view ensemble = {});

}  // namespace polhode
