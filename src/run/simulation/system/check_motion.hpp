// SPDX-License-Identifier: MIT
// Checks that a state that callers have changed is physically possible for the molecules.
#pragma once

#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// Checks positions, momenta, orientations and angular momenta, and normalizes the orientations.
/// @throws Error  if a number is not finite, a position is out of range, an orientation is zero, or
///   an angular momentum has a component along an axis with no moment of inertia. The message gives
///   the number of the molecule, counted from 1
void check_motion(State& state, const Bodies& bodies);

}  // namespace polhode
