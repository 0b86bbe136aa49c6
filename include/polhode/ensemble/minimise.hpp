// SPDX-License-Identifier: MIT
// Minimises the energy of rigid bodies by FIRE, the fast inertial relaxation engine [bitzek2006].
#pragma once

#include <cstddef>
#include <functional>

#include "polhode/base/workers.hpp"
#include "polhode/model/load.hpp"
#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// Convergence criteria and step limits of a minimisation.
struct MinimisationSettings {
  double force = 10;              ///< bound on the largest force on a body [kJ/mol/nm]
  double torque = 1;              ///< bound on the largest torque on a body [kJ/mol]
  std::size_t max_steps = 20000;  ///< maximum number of steps, each with one force evaluation
  /// Bound [nm] on the displacement of a body's centre in a step. The same bound applies to the
  /// displacement of the outermost site by rotation, to first order. The default is 1/60 of the
  /// diameter of an atom.
  double max_move = 0.005;
};

/// The energy of a configuration, and the largest force and torque on its bodies.
struct Steepness {
  double potential = 0;  ///< [kJ/mol]
  double force = 0;      ///< largest force on a body [kJ/mol/nm]
  double torque = 0;     ///< largest torque on a body about its centre of mass [kJ/mol]
};

enum class MinimisationEnd {
  converged,  ///< force and torque are within their bounds
  max_steps,
  stopped  ///< the caller stopped it
};

struct Minimisation {
  Steepness before, after;
  std::size_t steps = 0;
  /// Number of force evaluations: one before the first step, and one per step.
  std::size_t evaluations() const { return steps + 1; }
  MinimisationEnd end = MinimisationEnd::converged;
};

/// Computes forces, torques and energies of a state.
using EvaluateLoad = std::function<void(const State&, Load&)>;

/// A function that is called before every step and ends the minimisation by returning true.
using MinimisationWatch = std::function<bool(std::size_t steps, const Steepness& now)>;

/// Moves bodies towards lower energy by FIRE [bitzek2006, guenole2020], with kicks and drifts, so
/// that bodies stay rigid. Momenta turn towards the forces by p ← (1 − α) p + α c f and ℓ ← (1 − α)
/// ℓ + α c τ with c = √(Σ(p²/m + L·J⁻¹L) / Σ(f²/m + τ·J⁻¹τ)). The step grows as long as the power
/// Σ(f·p/m + τ·J⁻¹L) is positive. If the power is not positive, the step shrinks, and momenta are
/// set to 0. Displacements are capped, so overlapping molecules separate slowly.
///
/// Momenta are 0 afterwards. A state that is already within the bounds keeps its positions and
/// orientations, bit for bit. The final state is the same for any number of threads, if this holds
/// for `evaluate`.
/// @throws RunError  if a force is not finite
Minimisation minimise(State& state, const Topology& topology, const Bodies& bodies,
                      const EvaluateLoad& evaluate, const MinimisationSettings& settings = {},
                      const MinimisationWatch& watch = {}, Workers& workers = Workers::serial());

}  // namespace polhode
