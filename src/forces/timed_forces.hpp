// SPDX-License-Identifier: MIT
// A force field with a stopwatch.
#pragma once

#include "base/stopwatch.hpp"
#include "forces/pairs/neighbours.hpp"
#include "polhode/forces/force_field.hpp"

namespace polhode {

/// The forces, torques and derivatives of a force field for an integrator, and the computing time
/// spent on them.
struct TimedForces {
  ForceField& forces;
  double seconds = 0;  ///< computing time of all calls [s], including rebuilds of the list

  void operator()(const State& state, Load& load) {
    seconds += seconds_of([&] { forces(state, load); });
  }
  void forces_alone(const State& state, Load& load) {
    seconds += seconds_of([&] { forces.forces_alone(state, load); });
  }
  void directional_derivative(const State& state, const Vec3Column& dq, const Vec3Column& dtheta,
                              Load& slope) {
    seconds += seconds_of([&] { forces.directional_derivative(state, dq, dtheta, slope); });
  }
  /// The time that calls of the force field have spent on rebuilds of the neighbour list [s].
  double in_list() const { return forces.neighbours().seconds(); }
};

}  // namespace polhode
