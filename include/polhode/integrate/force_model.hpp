// SPDX-License-Identifier: MIT
// The interface that integrators require of a force model.
#pragma once

#include "polhode/model/load.hpp"
#include "polhode/model/state.hpp"

namespace polhode {

/// A type that computes the Load at a State. The optional member forces_alone(state, load) computes
/// no energies.
template <class F>
concept ForceModel = requires(F& forces, const State& state, Load& load) {
  {forces(state, load)};
};

/// A force model with the exact derivative of its forces and torques along a displacement of the
/// bodies, as needed by gradient kicks.
template <class F>
concept OffersDerivative = requires(F& forces, const State& state, const Vec3Column& displacement,
                                    Load& slope) {
  {forces.directional_derivative(state, displacement, displacement, slope)};
};

/// Evaluates forces and torques, without energies if the model can skip them.
/// @return  whether the Load includes energies anyway
template <ForceModel Forces>
bool forces_alone(Forces& forces, const State& state, Load& load) {
  if constexpr (requires { forces.forces_alone(state, load); }) {
    forces.forces_alone(state, load);
    return false;
  } else {
    forces(state, load);
    return true;
  }
}

}  // namespace polhode
