// SPDX-License-Identifier: MIT
// The integrator of a trajectory together with timed forces. The integrator uses a single scheme,
// or two schemes for multiple time steps. Clocks divide the computing time among the parts of a
// trajectory.
#pragma once

#include <algorithm>
#include <optional>

#include "base/stopwatch.hpp"
#include "forces/timed_forces.hpp"
#include "integrate/postprocessor.hpp"
#include "polhode/integrate/nested_integrator.hpp"
#include "polhode/run/simulation/trajectory/trajectory.hpp"
#include "run/simulation/system/near_forces.hpp"
#include "run/simulation/trajectory/ensemble_moves.hpp"

namespace polhode {

class TimedIntegrator {
 public:
  TimedIntegrator(System& system, ForceField& forces, const TrajectorySettings& settings,
                  EnsembleMoves::Bath bath, Workers& workers)
      : whole{forces}, step_(settings.step) {
    settings.check_processed();
    if (settings.processed)
      reader_.emplace(postprocessor_of(settings.scheme)->stages, system.bodies, whole,
                      settings.lambda, workers);
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
    if (!reader_) return;
    IntegratorMemory nothing = reader_->memory();  // the counts are in those of the integrator
    nothing.evaluations = nothing.measurements = 0;
    reader_->resume_from(nothing);
  }

  IntegratorMemory memory() {
    IntegratorMemory memory = apply([](const auto& integrator) { return integrator.memory(); });
    memory.measurements += evaluations_of_reader();
    return memory;
  }

  /// Forces and torques at the positions of a state, with energies.
  const Load& load(const State& state) {
    return apply([&](auto& integrator) -> const Load& { return integrator.load(state); });
  }
  /// Applies the postprocessor of the scheme to a copy of the state after the last step. Only for
  /// settings with `processed`.
  /// @param read  the copy
  /// @return forces and torques at the positions after the postprocessor, with energies
  const Load& process(State& read) {
    if (single_->scheme().ends_with_kick())
      reader_->replace_load(single_->forces(read));
    else
      reader_->forget();
    const double time = read.time;
    reader_->advance(read, step_);
    read.time = time;
    return reader_->load(read);
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
      trajectory.measurements = integrator.measurements() + evaluations_of_reader();
    });
    trajectory.list_rebuilds = whole.forces.list_rebuilds();
    if (!nested_) return;
    trajectory.near_evaluations = nested_->near_evaluations();
    trajectory.near_derivatives = nested_->near_derivatives();
  }

  TimedForces whole;
  std::optional<TimedForces> near;  // near forces of an inner scheme

 private:
  std::uint64_t evaluations_of_reader() const {
    return reader_ ? reader_->force_evaluations() + reader_->measurements() : 0;
  }

  double step_;
  std::optional<Integrator<TimedForces>>
      reader_;  // applies the postprocessor to copies of the state
  std::optional<Integrator<TimedForces, FreeDrift, EnsembleMoves::Bath>> single_;
  std::optional<ForceField> near_forces_;
  Load complete_;
  std::optional<NestedIntegrator<TimedForces, TimedForces, EnsembleMoves::Bath>> nested_;
};

/// Measures the computing time of each part of the program; for a resumed run, the time before the
/// interruption is added.
class Clocks {
 public:
  /// @param near  near forces of an optional inner scheme
  Clocks(const TimedForces& whole, const TimedForces* near, const Timings& earlier)
      : whole_(whole),
        near_(near),
        earlier_(earlier),
        list_before_(in_list(&whole)),
        near_list_before_(in_list(near)) {}
  double in_forces() const { return whole_.seconds + (near_ ? near_->seconds : 0); }
  /// Adds the time since the last call of this function or skip_pause() to drifts, kicks and
  /// forces.
  void add_motion() { motion_ += part_.lap(); }
  void skip() { part_.lap(); }
  void forces_of_sample(double seconds) { forces_of_samples_ += seconds; }
  /// Discards the time since the last call, because it is not part of the trajectory.
  void skip_pause() {
    run_.lap();
    skip();
  }
  Timings timings() {
    all_ += run_.lap();
    const double list = in_list(&whole_) - list_before_;
    const double near_list = in_list(near_) - near_list_before_;
    const double motion = motion_ - (in_forces() - forces_of_samples_);
    return {earlier_.forces + whole_.seconds - list, earlier_.list + list + near_list,
            earlier_.motion + motion,
            earlier_.measurement + std::max(0.0, all_ - in_forces() - motion),
            earlier_.near + (near_ ? near_->seconds : 0) - near_list};
  }

 private:
  static double in_list(const TimedForces* timed) { return timed ? timed->in_list() : 0; }

  const TimedForces& whole_;
  const TimedForces* near_;
  Timings earlier_;
  double list_before_, near_list_before_;
  double all_ = 0, motion_ = 0;
  double forces_of_samples_ = 0;  // schemes that end with a drift need forces for the energy
  Stopwatch run_, part_;
};

}  // namespace polhode
