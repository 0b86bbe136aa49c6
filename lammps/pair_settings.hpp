// SPDX-License-Identifier: MIT
// The arguments of pair_style polhode.
#pragma once

#include "polhode/forces/laws/settings.hpp"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace polhode::lammps {

/// The unit of length of the input script [nm]; in units lj, σ counts as 1 nm.
/// @throws Error  for units in which molecules are many orders of magnitude smaller than 1
double length_unit(LAMMPS_NS::LAMMPS* lammps);

/// Settings with lengths in nm. Energies have the unit of the input script.
/// @param arguments  behind the style, `count` of them
/// @throws Error     with the argument that is wrong
ForceSettings pair_settings(int count, char** arguments, LAMMPS_NS::LAMMPS* lammps);

}  // namespace polhode::lammps
