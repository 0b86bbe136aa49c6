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

/// When a minimisation ends, and how far it moves at once.
struct MinimisationSettings {
  double force = 10;              ///< bound of the largest force on a body [kJ/mol/nm]
  double torque = 1;              ///< bound of the largest torque [kJ/mol]
  std::size_t max_steps = 20000;  ///< largest number of steps, of one force evaluation each
  /// Largest move of the centre of a body in a step, and of its outermost site by rotation, to
  /// first order [nm]; 1/60 of the diameter of an atom.
  double max_move = 0.005;
};

/// The energy of a configuration, and how far it is from a minimum.
struct Steepness {
  double potential = 0;  ///< [kJ/mol]
  double force = 0;      ///< the largest on a body [kJ/mol/nm]
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
  /// One for each step, and one before the first.
  std::size_t evaluations() const { return steps + 1; }
  MinimisationEnd end = MinimisationEnd::converged;
};

/// Computes forces, torques and energies of a state.
using EvaluateLoad = std::function<void(const State&, Load&)>;

/// Called before every step; true ends the minimisation.
using MinimisationWatch = std::function<bool(std::size_t steps, const Steepness& now)>;

/// Moves bodies downhill by FIRE [bitzek2006, guenole2020], with kicks and drifts, so that bodies
/// stay rigid. Momenta turn towards forces, p ← (1 − α) p + α c f and ℓ ← (1 − α) ℓ + α c τ with c
/// = √(Σ(p²/m + L·J⁻¹L) / Σ(f²/m + τ·J⁻¹τ)). The step grows as long as the power Σ(f·p/m + τ·J⁻¹L)
/// is positive. Otherwise the step shrinks, and momenta are set to 0. Moves are capped, so
/// overlapping molecules separate slowly.
///
/// Momenta are 0 afterwards. A state that is already within the bounds keeps its positions and
/// orientations, bit for bit. The result is the same for any number of threads, if this holds for
/// `evaluate`.
/// @throws RunError  if a force is not finite
Minimisation minimise(State& state, const Topology& topology, const Bodies& bodies,
                      const EvaluateLoad& evaluate, const MinimisationSettings& settings = {},
                      const MinimisationWatch& watch = {}, Workers& workers = Workers::serial());

}  // namespace polhode
