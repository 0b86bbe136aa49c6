// SPDX-License-Identifier: MIT
// Forces that are not part of the force field: an external field, a user-defined potential, or
// forces from another program.
#pragma once

#include <functional>
#include <string>

#include "polhode/model/load.hpp"
#include "polhode/model/state.hpp"

namespace polhode {

/// Forces that are added to a force field. The forces must depend only on positions, orientations
/// and box, because an evaluation is reused until one of these three changes.
struct ExternalForces {
  std::string name;  ///< name in messages and checkpoints; a checkpoint is valid only for runs with
                     ///< this name
  /// Adds the external forces, torques, energy (Load::external), and virial if `has_virial` is set.
  std::function<void(const State& state, Load& load)> add{};
  bool has_virial = false;  ///< whether `add` sets the virial; otherwise, pressures do not include
                            ///< the external forces
};

/// Adds the derivative of external forces and torques along a displacement of all bodies, as in
/// ForceField::directional_derivative(). The derivative is a central difference with a relative
/// error of about 1e-9 for forces that vary over 0.1 nm.
void add_derivative(const ExternalForces& forces, const State& state, const Vec3Column& dq,
                    const Vec3Column& dtheta, Load& slope);

}  // namespace polhode
