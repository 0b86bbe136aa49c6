// SPDX-License-Identifier: MIT
// The motion of the centre of mass. The motion of the centre of mass does not contribute to
// temperature or diffusion, so the program keeps the centre of mass at rest. The total momentum of
// an initial configuration and the net force of a mesh are removed. Kinetic energies, temperatures,
// pressures and displacements are relative to the centre of mass (docs/theory.md, Eq. (32)).
#pragma once

#include "polhode/base/workers.hpp"
#include "polhode/model/load.hpp"
#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

double total_mass(const Bodies& bodies);  ///< The total mass Σ m [u].

/// The total momentum Σ p [u nm/ps].
Vec3<double> total_momentum(const State& state);

/// The centre of mass Σ m q/M [nm] of unwrapped positions.
Vec3<double> centre_of_mass(const Vec3Column& q, const Bodies& bodies);

/// Brings the centre of mass to rest: p ← p − m P/M with P = Σ p.
/// @return  the subtracted velocity P/M [nm/ps]
Vec3<double> remove_total_momentum(State& state, const Bodies& bodies);

/// Transforms momenta to a frame that moves at velocity u [nm/ps]: p ← p − m u.
void subtract_velocity(State& state, const Bodies& bodies, const Vec3<double>& u,
                       Workers& workers = Workers::serial());

/// Subtracts the net force F, divided among the bodies in proportion to their masses: f ← f − m
/// F/M. The result is minus the gradient of the energy at a fixed centre of mass; torques do not
/// change. The result is bitwise identical for any number of threads.
void remove_net_force(Load& load, const Bodies& bodies, Workers& workers = Workers::serial());

}  // namespace polhode
