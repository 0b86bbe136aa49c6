// SPDX-License-Identifier: MIT
// The two flows that every scheme is made of (vanzon2008, Eqs. 2 and 3).
#pragma once

#include "polhode/model/load.hpp"
#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// e^{At}: every body flies straight and turns freely, both exactly (vanzon2008, Eq. 2):
/// q ← q + t p/m, S ← P(t) S.
void drift(State& state, const Bodies& bodies, double t);

/// e^{Bt}: forces and torques act (vanzon2008, Eq. 3): p ← p + t f, ℓ ← ℓ + t τ.
void kick(State& state, const Load& load, double t);

}  // namespace polhode
