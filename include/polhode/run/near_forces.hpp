// SPDX-License-Identifier: MIT
// The near part of forces, for multiple time steps.
#pragma once

#include <string>

#include "polhode/integrate/nested_scheme.hpp"
#include "polhode/run/system.hpp"

namespace polhode {

/// Settings of the near forces of an inner scheme: Lennard-Jones and Coulomb's law between
/// molecules, whatever the whole law is, faded by the distance of their centres as with a molecule
/// switch. What the whole law has beyond, at any distance, is slow: where the near part is whole,
/// the tail of a reaction field or the waves of Ewald's sum, which change little as molecules turn.
/// @throws Error  if near forces would reach farther than the whole
ForceSettings near_settings(const ForceSettings& whole, const InnerScheme& inner);

/// Refuses, with the place, an inner scheme whose near forces do not fit.
void check_near(const ForceSettings& whole, const NestedScheme& scheme, const std::string& place);

/// Time of an evaluation of the near forces over one of the whole, at the system's state, forces
/// alone and lists at hand: the best of several of each, taken in turn. 0 without an inner scheme.
double near_weight(const System& system, const std::optional<InnerScheme>& inner);

}  // namespace polhode
