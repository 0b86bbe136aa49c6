// SPDX-License-Identifier: MIT
// The conditions under which fix polhode rejects a LAMMPS input.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace LAMMPS_NS {
class Fix;
class LAMMPS;
}  // namespace LAMMPS_NS

namespace polhode::lammps {

/// Whether a LAMMPS style is one of a list, in any variant such as "shake/kk".
bool is_variant_of(std::string_view style, std::span<const std::string_view> names);

/// Whether an atom is in the groups of both fixes.
bool shares_atoms(LAMMPS_NS::LAMMPS* lammps, const LAMMPS_NS::Fix* a, const LAMMPS_NS::Fix* b);

/// What the checks depend on.
struct CheckedScheme {
  std::size_t evaluations = 1;  ///< number of force evaluations in a step
  bool amplifies = false;       ///< whether gradient kicks divide differences of forces by a small
                                ///< λ, so that forces must depend on positions alone
};

/// Checks conditions that are known before a run. Minimisation, r-RESPA, changes of the box, and
/// other fixes that integrate the same atoms or change their positions, velocities or number are
/// not supported. Fixes that add forces must precede fix polhode.
/// @throws Error  if a condition is not met
void check_system(LAMMPS_NS::LAMMPS* lammps, const LAMMPS_NS::Fix* own,
                  const CheckedScheme& scheme);

/// Whether another fix reads velocities of the same atoms when forces are computed, as a thermostat
/// that adds friction does.
bool needs_half_step_velocities(LAMMPS_NS::LAMMPS* lammps, const LAMMPS_NS::Fix* own);

/// Intervals at which fixes other than fix polhode act at the end of a step.
std::vector<int> intervals_of_fixes(const LAMMPS_NS::LAMMPS* lammps, const LAMMPS_NS::Fix* own);

/// Whether something other than output and pressures may read velocities at any step: another fix,
/// a pair style with friction, or a variable that scales pair styles.
bool may_read_velocities(const LAMMPS_NS::LAMMPS* lammps, const LAMMPS_NS::Fix* own);

/// Checks that a run, its thermodynamic output, its dumps, and fixes that act at the end of steps
/// are at whole steps of the scheme.
/// @param phase  number of evaluations of the current step that precede the run
/// @throws Error  if one of these times is within a step of the scheme
void check_intervals(LAMMPS_NS::LAMMPS* lammps, const LAMMPS_NS::Fix* own, std::size_t evaluations,
                     std::size_t phase);

}  // namespace polhode::lammps
