// SPDX-License-Identifier: MIT
// The near part of the forces, for multiple time steps.
#pragma once

#include <string>

#include "polhode/integrate/nested_scheme.hpp"
#include "polhode/run/simulation/system/system.hpp"

namespace polhode {

/// Settings of the near forces of an inner scheme. Whatever the electrostatics of the full forces,
/// the near forces are Lennard-Jones and Coulomb interactions with a molecule switch to zero. The
/// slow forces are the full forces minus the near forces. Inside the switching distance, the slow
/// forces are only the reaction-field term or the reciprocal-space part of PME, which vary slowly
/// as molecules rotate.
/// @throws Error  if the near forces would have a longer range than the full forces
ForceSettings near_settings(const ForceSettings& whole, const InnerScheme& inner);

/// Checks that the cutoff of the near forces does not exceed the cutoff of the full forces;
/// otherwise throws an Error with the place of the inner scheme.
void check_near(const ForceSettings& whole, const NestedScheme& scheme, const std::string& place);

/// The computing time of a near-force evaluation relative to an evaluation of all forces, in the
/// current state of the system. Energies and list builds are not included. The evaluations of near
/// forces and of all forces are repeated several times in alternation, and the minimum times are
/// used. Without an inner scheme, the relative computing time is 0.
double near_weight(const System& system, const std::optional<InnerScheme>& inner);

}  // namespace polhode
