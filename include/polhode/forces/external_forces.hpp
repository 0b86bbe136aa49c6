// SPDX-License-Identifier: MIT
// Forces from outside of the force field: a field, a potential of the user, another program.
#pragma once

#include <functional>
#include <string>

#include "polhode/model/load.hpp"
#include "polhode/model/state.hpp"

namespace polhode {

/// Forces that are added to those of a force field. They must be a function of positions,
/// orientations and box alone, since an evaluation is reused until one of these changes.
struct ExternalForces {
  std::string name;  ///< in messages, and in checkpoints, which are of the same name only
  /// Adds forces, torques, the energy (Load::external), and the virial if they have one.
  std::function<void(const State& state, Load& load)> add{};
  bool has_virial = false;  ///< without one, pressures lack the part of these forces
};

/// Adds the derivative of external forces and torques along a displacement of all bodies, as in
/// ForceField::directional_derivative(), by a central difference: its relative error is of the
/// order of 1e-9 for forces that vary over 0.1 nm.
void add_derivative(const ExternalForces& forces, const State& state, const Vec3Column& dq,
                    const Vec3Column& dtheta, Load& slope);

}  // namespace polhode
