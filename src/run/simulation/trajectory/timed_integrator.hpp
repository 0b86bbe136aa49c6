// SPDX-License-Identifier: MIT
// The integrator of a trajectory together with timed forces. The integrator uses a single scheme,
// or two schemes for multiple time steps.
#pragma once

#include <optional>

#include "forces/timed_forces.hpp"
#include "polhode/integrate/flows.hpp"
#include "polhode/integrate/nested_integrator.hpp"
#include "polhode/run/simulation/trajectory/trajectory.hpp"
#include "run/simulation/system/near_forces.hpp"
#include "run/simulation/trajectory/ensemble_moves.hpp"

namespace polhode {

class TimedIntegrator {
 public:
  TimedIntegrator(System& system, ForceField& forces, const TrajectorySettings& settings,
                  EnsembleMoves::Bath bath, Workers& workers)
      : whole{forces} {
    if (!settings.inner) {
      single_.emplace(settings.scheme, system.bodies, whole, FreeDrift{system.bodies, workers},
                      bath, settings.lambda, workers);
      return;
    }
    near_forces_.emplace(system.topology, near_settings(forces.settings(), *settings.inner),
                         system.state.box, workers);
    near.emplace(TimedForces{*near_forces_});
    nested_.emplace(NestedScheme{settings.scheme, settings.inner}, system.bodies, whole, *near,
                    settings.lambda, workers, bath);
  }
  TimedIntegrator(const TimedIntegrator&) = delete;
  TimedIntegrator& operator=(const TimedIntegrator&) = delete;

  /// Calls f with the integrator, which is simple or nested.
  template <class F>
  decltype(auto) apply(const F& f) {
    return single_ ? f(*single_) : f(*nested_);
  }

  void resume_from(const RunState& state) {
    apply([&](auto& integrator) { integrator.resume_from(state.integrator); });
    whole.forces.resume_from(state.list, state.state.box);
    if (near) near->forces.resume_from(state.near_list, state.state.box);
  }

  IntegratorMemory memory() {
    return apply([](const auto& integrator) { return integrator.memory(); });
  }

  /// Forces and torques at the positions of a state, with energies.
  const Load& load(const State& state) {
    return apply([&](auto& integrator) -> const Load& { return integrator.load(state); });
  }
  /// Forces and torques of the last kick.
  const Load& last_load() {
    return apply([](const auto& integrator) -> const Load& { return integrator.last_load(); });
  }
  /// Forces and torques of the last kick. With an inner scheme, the result contains all forces in a
  /// state, although the outer scheme uses only the slow forces.
  const Load& all_forces(const State& state) {
    if (!near) return last_load();
    whole.forces.forces_alone(state, complete_);
    return complete_;
  }

  void count(Trajectory& trajectory) {
    apply([&](const auto& integrator) {
      trajectory.force_evaluations = integrator.force_evaluations();
      trajectory.derivatives = integrator.derivatives();
      trajectory.measurements = integrator.measurements();
    });
    trajectory.list_rebuilds = whole.forces.list_rebuilds();
    if (!nested_) return;
    trajectory.near_evaluations = nested_->near_evaluations();
    trajectory.near_derivatives = nested_->near_derivatives();
  }

  TimedForces whole;
  std::optional<TimedForces> near;  // near forces of an inner scheme

 private:
  std::optional<Integrator<TimedForces, FreeDrift, EnsembleMoves::Bath>> single_;
  std::optional<ForceField> near_forces_;
  Load complete_;
  std::optional<NestedIntegrator<TimedForces, TimedForces, EnsembleMoves::Bath>> nested_;
};

}  // namespace polhode
