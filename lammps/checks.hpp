// SPDX-License-Identifier: MIT
// The conditions under which fix polhode rejects a LAMMPS input.
#pragma once

#include <cstddef>

namespace LAMMPS_NS {
class Fix;
class LAMMPS;
}  // namespace LAMMPS_NS

namespace polhode::lammps {

/// Checks conditions that are known before a run. Minimisation, r-RESPA, changes of the box, and
/// other fixes that integrate or change velocities of the same atoms are not supported.
/// @param evaluations  number of force evaluations in a step of the scheme
/// @throws Error  if a condition is not met
void check_system(LAMMPS_NS::LAMMPS* lammps, const LAMMPS_NS::Fix* own, std::size_t evaluations);

/// Checks that a run, its thermodynamic output, dumps and averages are at whole steps of the
/// scheme.
/// @param phase  number of evaluations of the current step that precede the run
/// @throws Error  if one of these times is within a step of the scheme
void check_intervals(LAMMPS_NS::LAMMPS* lammps, std::size_t evaluations, std::size_t phase);

}  // namespace polhode::lammps
