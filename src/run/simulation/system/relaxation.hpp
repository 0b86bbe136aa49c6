// SPDX-License-Identifier: MIT
// Moves molecules of a system downhill: to a minimum of the energy, or only until their dynamics
// can begin.
#pragma once

#include <functional>
#include <string>

#include "polhode/ensemble/minimise.hpp"
#include "polhode/run/callbacks.hpp"
#include "polhode/run/simulation/system/system.hpp"

namespace polhode {

/// Minimises the energy of a system with its forces in double precision, since energies of overlaps
/// exceed the range of a float. Each body keeps its momentum p and its angular momentum L in the
/// body frame, so that a Maxwell distribution stays one.
/// @throws RunError  naming two molecules, if a force is not finite
Minimisation minimise(System& system, const MinimisationSettings& settings = {},
                      const MinimisationWatch& watch = {}, Workers& workers = Workers::serial());

/// Reports the progress of a minimisation, and ends it when the callbacks ask for it.
MinimisationWatch watch_of(const Callbacks& callbacks);

/// "minimised in 312 steps: largest force 9.98 kJ/mol/nm, largest torque 0.41 kJ/mol", or why it
/// ended earlier.
std::string description(const Minimisation& minimisation);

/// The forces [kJ/mol/nm] and torques [kJ/mol] with which dynamics in steps of 1 fs can begin:
/// larger than those of liquids.
inline constexpr double max_initial_force = 2e4, max_initial_torque = 500;

/// Whether the forces or torques of a state are beyond these bounds, or not finite.
bool molecules_overlap(const System& system, const State& state);

/// Refuses a lattice from which dynamics are to begin at once, if its molecules overlap. Other
/// initial configurations are as the user made them.
/// @throws Error  naming two molecules, with a density at which the lattice does not overlap
void check_lattice(const System& system, const Config& config);

/// Minimises until forces and torques are within these bounds. Configurations without larger ones,
/// such as those of liquids, stay unchanged bit by bit.
/// @param stop  asked before every step; true ends it
/// @return  the number of steps
/// @throws RunError  naming two molecules, if forces are still larger after 2000 steps, as at
///                   densities beyond that of the liquid
std::size_t separate_molecules(System& system, const std::function<bool()>& stop = {},
                               Workers& workers = Workers::serial());

/// @throws RunError  naming two molecules, unless forces and torques are within these bounds
void check_separated(const System& system, const Minimisation& minimisation);

}  // namespace polhode
