// SPDX-License-Identifier: MIT
// The bracket W of the O(h²) error of schemes, divided into kinds of motion.
#pragma once

#include <array>

#include "polhode/model/load.hpp"
#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// A quantity for each kind of motion: translation, then rotation about each principal axis.
template <class T>
using ByMotion = std::array<T, 4>;

/// Squared forces of each kind of motion: Σ |f|²/m for translation, and Σ τ_k²/J_k for rotation
/// about each principal axis k [kJ/mol/ps²]. The sum of the squared forces is W = {V,{V,T}} = Σ
/// |f|²/m + (S τ)·J⁻¹ (S τ).
ByMotion<double> squared_force(const State& state, const Bodies& bodies, const Load& load);

}  // namespace polhode
