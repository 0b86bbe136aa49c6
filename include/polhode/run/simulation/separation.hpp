// SPDX-License-Identifier: MIT
// Moves overlapping molecules apart, so that their dynamics can begin.
#pragma once

#include <functional>

#include "polhode/run/simulation/system.hpp"

namespace polhode {

/// The largest distance that the centre of a body moves in one step of separate_molecules(), and
/// that its outermost site moves by rotation [nm]: a sixtieth of the diameter of an atom.
inline constexpr double max_separation_move = 0.005;

/// Steepest descent with capped moves: each body moves by h² f/m and turns by h² J⁻¹τ, as from rest
/// within a time h = 1 fs, but no farther than `max_separation_move`. It ends when no move is
/// capped any more: the forces then are such that dynamics in steps of 1 fs can take over. Momenta
/// stay. Configurations without such forces, such as those of liquids, stay unchanged bit by bit.
/// @param stop  asked after every step; true ends it
/// @return  the number of steps
/// @throws RunError  naming two molecules, if moves are still capped after 2000 steps, as at
///                   densities beyond that of the liquid
std::size_t separate_molecules(System& system, const std::function<bool()>& stop = {},
                               Workers& workers = Workers::serial());

}  // namespace polhode
