// SPDX-License-Identifier: MIT
// Forces from outside of the force field: a field, a potential of the user, another program.
#pragma once

#include <functional>
#include <string>

#include "polhode/model/load.hpp"
#include "polhode/model/state.hpp"

namespace polhode {

/// Forces that are added to a force field. They must be a function of positions, orientations and
/// box only, because an evaluation is reused until one of these changes.
struct ExternalForces {
  std::string name;  ///< name in messages, and in checkpoints, which fit this name only
  /// Adds forces, torques, the energy (Load::external), and the virial if they have one.
  std::function<void(const State& state, Load& load)> add{};
  bool has_virial = false;  ///< whether `add` sets the virial; if not, pressures lack the forces
};

/// Adds the derivative of external forces and torques along a displacement of all bodies, as in
/// ForceField::directional_derivative(). It is a central difference, whose relative error is about
/// 1e-9 for forces that vary over 0.1 nm.
void add_derivative(const ExternalForces& forces, const State& state, const Vec3Column& dq,
                    const Vec3Column& dtheta, Load& slope);

}  // namespace polhode
