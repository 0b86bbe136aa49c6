// SPDX-License-Identifier: MIT
// The time scale of a system, estimated before the simulation.
#pragma once

#include "polhode/run/simulation/system/system.hpp"

namespace polhode {

/// The Einstein frequency of the fastest degrees of freedom of a liquid [1/ps], from the forces in
/// a single state. The square of the frequency is ⟨f²⟩/(m k_B T) for translation, and ⟨τ_k²⟩/(J_k
/// k_B T) for rotation about each axis. Averages are taken over each kind of molecule separately.
double einstein_frequency(const System& system, const State& state,
                          Workers& workers = Workers::serial());

}  // namespace polhode
