// SPDX-License-Identifier: MIT
// Molecules that are too close, and their motion downhill: to a minimum of the energy, or only
// until their dynamics can begin.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "polhode/ensemble/minimise.hpp"
#include "polhode/run/callbacks.hpp"
#include "polhode/run/simulation/system/system.hpp"

namespace polhode {

/// The strongest contact of a state as text, such as "molecules 3 (benzene) and 17 (benzene) are
/// 0.0931 nm apart, between H2 and C5". The first molecule is the molecule with the largest force,
/// or the first molecule with a force that is not finite. The second molecule has the site that is
/// closest to a site of the first molecule. Sites with neither mass nor a short-range potential are
/// ignored. The text is empty if the state or all forces are not finite, or if there is only one
/// molecule.
std::string strongest_contact(const System& system, const State& state);

/// Minimises the energy of a system. Forces are in double precision, because energies of overlaps
/// exceed the range of a float. Each body keeps its momentum p and its body-frame angular momentum
/// L, so that a Maxwell distribution is preserved.
/// @throws RunError  if a force is not finite; the message names two molecules
Minimisation minimise(System& system, const MinimisationSettings& settings = {},
                      const MinimisationWatch& watch = {}, Workers& workers = Workers::serial());

/// Makes a watch that reports the progress of a minimisation, and ends the minimisation on request
/// of the callbacks.
MinimisationWatch watch_of(const Callbacks& callbacks);

/// The result of a minimisation as text, such as "minimised in 312 steps: largest force 9.98
/// kJ/mol/nm, largest torque 0.41 kJ/mol". If the minimisation ended early, the text gives the
/// reason.
std::string description(const Minimisation& minimisation);

/// The largest forces [kJ/mol/nm] and torques [kJ/mol] with which dynamics can begin at a 1 fs time
/// step. The bounds on initial forces and torques are larger than the forces and torques in
/// liquids.
inline constexpr double max_initial_force = 2e4, max_initial_torque = 500;

/// Whether molecules of a state overlap: forces or torques exceed the bounds for initial
/// configurations, or are not finite.
bool molecules_overlap(const System& system, const State& state);

/// Advice about a lattice with overlapping molecules, such as ", or a density of 0.79 g/cm3, at
/// which this lattice fits". Lattices with the same seed are tried in larger boxes of the same
/// shape, with densities that decrease by 10 % each. The text is empty if molecules overlap at all
/// densities down to 5 % of the original density.
std::string fitting_density(const Topology& topology, const Box& box, std::uint64_t seed,
                            const std::function<bool(const State&)>& overlaps);

/// Rejects a lattice with overlapping molecules if the dynamics would start from this lattice
/// without minimisation. Other initial configurations are not checked.
/// @throws Error  with two molecules, and a density at which the lattice does not overlap
void check_lattice(const System& system, const Config& config);

/// Minimises until forces and torques are within the bounds for initial configurations. If forces
/// and torques are within the bounds already, as in liquids, the configuration remains bitwise
/// identical.
/// @param stop  function called before every step; the minimisation ends if it returns true
/// @return  number of steps
/// @throws RunError  if forces are still too large after 2000 steps, as at densities above the
///   liquid density; the message names two molecules
std::size_t separate_molecules(System& system, const std::function<bool()>& stop = {},
                               Workers& workers = Workers::serial());

/// Checks that molecules do not overlap.
/// @throws RunError  unless forces and torques are within the bounds for initial configurations;
///   the message names two molecules
void check_separated(const System& system, const Minimisation& minimisation);

}  // namespace polhode
