// SPDX-License-Identifier: MIT
// Simulations of a molecule that is coupled to all others in stages.
#pragma once

#include "polhode/run/simulation/system/system.hpp"
#include "run/properties/replica.hpp"

namespace polhode {

/// All stages from which a path can choose: first the short-range potentials of a molecule grow
/// from nothing to their full size, then its charges.
CouplingPath possible_stages(const Molecule& molecule);

/// A system in which the last molecule of the first kind is coupled to all others as in a stage.
/// Bodies keep their order.
System coupled(const System& whole, const CouplingStage& stage);

/// Steps of a segment at each stage.
inline constexpr std::size_t steps_of_coupling = 500, steps_of_coupling_sample = 20;
/// Steps by which each stage is relaxed before its first segment.
inline constexpr std::size_t steps_of_relaxation = 1250;

/// Chooses stages, each with enough overlap with the one before, by growing the molecule in the
/// system of a prepared pilot.
/// @return  false if it was stopped
/// @throws RunError  if the system blows up
bool choose_stages(Replica& pilot, const ReplicaSettings& settings);

/// Relaxes all stages, or adds a segment at each stage if they are relaxed.
/// @return  false if it was stopped; the replica is then unchanged
/// @throws RunError  if the system blows up
bool add_coupling(Replica& replica, const ReplicaSettings& settings);

}  // namespace polhode
