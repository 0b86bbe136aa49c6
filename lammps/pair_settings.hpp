// SPDX-License-Identifier: MIT
// The arguments of pair_style polhode.
#pragma once

#include "interactions.hpp"
#include "polhode/forces/laws/settings.hpp"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace polhode::lammps {

/// The unit of length of the input script [nm]. In units lj, σ is treated as 1 nm.
/// @throws Error  for units in which molecules are many orders of magnitude smaller than 1
double length_unit(LAMMPS_NS::LAMMPS* lammps);

/// Reads force settings with lengths in nm. Energies are in the unit of the input script.
/// @param arguments  the `count` arguments that follow the style
/// @throws Error     with the invalid argument
ForceSettings pair_settings(int count, char** arguments, LAMMPS_NS::LAMMPS* lammps);

/// Reads the potential of a pair_coeff command, in LAMMPS units: EPSILON SIGMA, mie EPSILON SIGMA N
/// M, or buckingham A RHO C.
/// @param words  the `count` words that follow the atom types
/// @throws Error  with the invalid value
PairCoefficients::Values pair_values(int count, char** words, LAMMPS_NS::LAMMPS* lammps);

}  // namespace polhode::lammps
