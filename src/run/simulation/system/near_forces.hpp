// SPDX-License-Identifier: MIT
// The near part of the forces, for multiple time steps.
#pragma once

#include <string>

#include "polhode/integrate/nested_scheme.hpp"
#include "polhode/run/simulation/system/system.hpp"

namespace polhode {

/// Settings of the near forces of an inner scheme: Lennard-Jones and Coulomb interactions between
/// molecules, whatever the full force field, with a molecule switch to zero. The slow part is the
/// rest of the full force field: inside the switching distance it is the reaction-field term or the
/// reciprocal-space part of PME, which vary slowly as molecules rotate.
/// @throws Error  if the near forces would have a longer range than the full ones
ForceSettings near_settings(const ForceSettings& whole, const InnerScheme& inner);

/// Throws, with the place, if the near forces of an inner scheme do not fit.
void check_near(const ForceSettings& whole, const NestedScheme& scheme, const std::string& place);

/// Time of an evaluation of the near forces relative to one of all forces, at the state of the
/// system, without energies and list builds: the minimum over several repeats of each, alternating.
/// 0 without an inner scheme.
double near_weight(const System& system, const std::optional<InnerScheme>& inner);

}  // namespace polhode
