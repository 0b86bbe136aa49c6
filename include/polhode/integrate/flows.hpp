// SPDX-License-Identifier: MIT
// The drift and kick of all bodies, from which every scheme is composed [vanzon2008, Eqs. 2 and 3],
// and the displacement that gradient kicks use. Bodies are advanced independently, so the results
// are bitwise identical for any number of threads.
#pragma once

#include "polhode/base/workers.hpp"
#include "polhode/model/load.hpp"
#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// The drift e^{At}: exact free flight and free rotation of every body [vanzon2008, Eq. 2]: q ← q +
/// t p/m, S ← P(t) S.
void drift(State& state, const Bodies& bodies, double t, Workers& workers = Workers::serial());

/// The kick e^{Bt}: forces and torques change momenta [vanzon2008, Eq. 3]: p ← p + t f, ℓ ← ℓ + t
/// τ. No torque acts along an axis with no moment of inertia. The round-off of τ adds a component
/// of ℓ along such an axis. This component is removed, because it would accumulate over the steps.
void kick(State& state, const Bodies& bodies, const Load& load, double t,
          Workers& workers = Workers::serial());

/// Computes the direction along which a gradient kick needs the derivative of the forces. This
/// direction is f/m for each centre, and J⁻¹ S τ in the body frame for each orientation. ∇W is
/// twice the derivative of f and τ along this direction.
void gradient_direction(const State& state, const Bodies& bodies, const Load& load, Vec3Column& dq,
                        Vec3Column& dtheta, Workers& workers = Workers::serial());

/// Displaces every body along the force and torque on it: q̃ = q + c f/m, S̃ = R(c J⁻¹ S τ) S
/// [vanzon2008, Eq. 7 with c = 2 ξ λ h²].
void displace(State& state, const Bodies& bodies, const Load& load, double c,
              Workers& workers = Workers::serial());

}  // namespace polhode
