// SPDX-License-Identifier: MIT
// The time scale of a system, before it is simulated.
#pragma once

#include "polhode/run/simulation/system/system.hpp"

namespace polhode {

/// The frequency of the fastest degrees of freedom [1/ps], ω² = ⟨f²⟩/(m k_B T) for translation and
/// ⟨τ_k²⟩/(J_k k_B T) for rotation about each axis, averaged over each kind of molecule separately:
/// the Einstein frequency of a liquid, from the forces at the positions of one state.
double einstein_frequency(const System& system, const State& state,
                          Workers& workers = Workers::serial());

}  // namespace polhode
