// SPDX-License-Identifier: MIT
// What fix polhode refuses in an input of LAMMPS.
#pragma once

#include <cstddef>

namespace LAMMPS_NS {
class Fix;
class LAMMPS;
}  // namespace LAMMPS_NS

namespace polhode::lammps {

/// Everything that is known before a run: minimisation, r-RESPA, boxes that change, other fixes
/// that integrate or change velocities of the same atoms.
/// @param evaluations  of the forces in a step of the scheme
/// @throws Error
void check_system(LAMMPS_NS::LAMMPS* lammps, const LAMMPS_NS::Fix* own, std::size_t evaluations);

/// That a run, its thermodynamic output, dumps and averages fall on whole steps of the scheme.
/// @param phase  evaluations of a step that precede the run
/// @throws Error
void check_intervals(LAMMPS_NS::LAMMPS* lammps, std::size_t evaluations, std::size_t phase);

}  // namespace polhode::lammps
