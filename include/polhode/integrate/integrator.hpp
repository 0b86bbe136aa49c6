// SPDX-License-Identifier: MIT
// Applies a scheme to a state: drifts, kicks and baths in the order of the stages. Any callable can
// supply the forces.
#pragma once

#include <concepts>
#include <cstdint>
#include <utility>
#include <vector>

#include "polhode/base/error.hpp"
#include "polhode/base/workers.hpp"
#include "polhode/integrate/flows.hpp"
#include "polhode/integrate/force_model.hpp"
#include "polhode/integrate/joined_flows.hpp"
#include "polhode/integrate/scheme.hpp"

namespace polhode {

/// The drift of all bodies: free flight and free rotation.
struct FreeDrift {
  const Bodies& bodies;
  Workers& workers;
  void operator()(State& state, double t) const { drift(state, bodies, t, workers); }
};

/// A placeholder for the bath in integrators of schemes that have no bath.
struct NoBath {};

/// A callable that drifts a state over a time t.
template <class F>
concept StateDrift = requires(F& drift, State& state, double t) {
  {drift(state, t)};
};

/// A callable that changes momenta over a time t; the stage number selects the random numbers.
template <class F>
concept StateBath = std::same_as<F, NoBath> ||
    requires(F& bath, State& state, double t, StageNumber at) {
  {bath(state, t, at)};
};

/// The data that an integrator keeps from step to step. An integrator that receives this memory
/// continues the trajectory bit for bit.
struct IntegratorMemory {
  Load load;              ///< load of the last evaluation
  bool current = false;   ///< whether `load` belongs to the current positions
  bool complete = false;  ///< whether `load` includes energies
  std::uint64_t steps = 0, evaluations = 0, derivatives = 0, measurements = 0;
  std::vector<IntegratorMemory> inner;  ///< memory of the inner scheme, if there is one
};

/// Applies step() to a state. The integrator joins adjacent stages, reuses forces while positions
/// do not change, and computes energies only on demand. The integrator also counts steps and
/// evaluations. The integrator works in place and owns the scratch space and the last Load, so a
/// step does not allocate memory.
/// @tparam Drift  drift to use instead of free motion, such as steps of an inner scheme
/// @tparam Bath   bath, for schemes that have one
template <ForceModel Forces, StateDrift Drift = FreeDrift, StateBath Bath = NoBath>
class Integrator {
 public:
  /// @param forces  kept by reference
  /// @param lambda  displacement factor of gradient kicks by finite difference [vanzon2008, Eq. 6]
  /// @param workers  threads for drifts and kicks, kept by reference; the force model has its own
  ///   threads
  /// @throws Error  if the scheme has exact gradients and the forces offer no derivative, or if the
  ///   scheme has a bath and no bath is given
  Integrator(const Scheme& scheme, const Bodies& bodies, Forces& forces, double lambda = 1e-4,
             Workers& workers = Workers::serial()) requires std::same_as<Drift, FreeDrift> &&
      std::same_as<Bath, NoBath>
      : Integrator(scheme, bodies, forces, FreeDrift{bodies, workers}, NoBath{}, lambda, workers) {}

  /// @param drift, bath  kept by value; pass std::ref() for an object whose state must be shared
  Integrator(const Scheme& scheme, const Bodies& bodies, Forces& forces, Drift drift, Bath bath,
             double lambda = 1e-4, Workers& workers = Workers::serial())
      : scheme_(scheme),
        bodies_(bodies),
        forces_(forces),
        drift_(std::move(drift)),
        bath_(std::move(bath)),
        lambda_(lambda),
        workers_(workers),
        load_(bodies.size()) {
    check_flows<StateFlows>(scheme);
    const auto stages = scheme.stages();
    for (std::size_t k = 0; k < stages.size(); ++k)
      if (stages[k].flow == Flow::drift) after_last_drift_ = k + 1;
    const bool exact = scheme.has(Gradient::exact);
    const bool difference = scheme.has(Gradient::finite_difference);
    if (exact && !OffersDerivative<Forces>)
      throw Error(
          "the scheme has exact gradient kicks, but the forces have no derivative; define "
          "directional_derivative, or use finite differences as in \"gier4-fd\"");
    if (exact) dq_ = dtheta_ = Vec3Column(bodies.size());
    if (difference) shifted_ = State(bodies.size(), {});
    if (exact || difference) gradient_load_ = Load(bodies.size());
  }

  /// Advances by `steps` steps e^{Lh} [vanzon2008, Eq. 1]. Adjacent stages of the same flow are
  /// joined, such as the last stage of a step and the first stage of the next step. At the end the
  /// state is synchronized: positions and momenta belong to the same time.
  /// @param energies  whether load() will need energies at the end; if not, load() computes them on
  ///   demand
  void advance(State& state, double h, std::size_t steps = 1, bool energies = true) {
    if (steps == 0) return;
    const double start = state.time;
    StateFlows flows{*this, state};
    JoinedFlows joined(flows, std::same_as<Drift, FreeDrift>);
    for (std::size_t n = 1; n < steps; ++n) step(scheme_, joined, h, steps_++);

    const std::span<const Stage> last = scheme_.stages();
    play(last.first(after_last_drift_), joined, h, {steps_, 0});
    flows.energies = energies;  // energies of the positions at the end
    play(last.subspan(after_last_drift_), joined, h, {steps_++, after_last_drift_});
    joined.flush();
    state.time = start + static_cast<double>(steps) * h;
  }

  /// The Load at the positions of the state. The result of the last kick is reused if the positions
  /// have not changed since then. Otherwise the forces are evaluated again, and this evaluation is
  /// counted as a measurement, not as part of the integration.
  const Load& load(const State& state) {
    if (!current_ || !complete_) {
      evaluate(state, true);
      ++measurements_;
    }
    return load_;
  }

  /// Forces and torques at the positions of the state. The forces of the last kick are reused if
  /// the positions have not changed since then. Otherwise the forces are evaluated again, as part
  /// of the integration.
  /// @param energies  whether a new evaluation should include energies
  const Load& forces(const State& state, bool energies = false) {
    if (!current_) {
      evaluate(state, energies);
      ++evaluations_;
    }
    return load_;
  }

  /// Forces and torques of the last kick, at the positions of that kick.
  const Load& last_load() const { return load_; }

  /// Discards the stored Load. Call this function after other code has changed positions or box.
  void forget() { current_ = false; }
  /// Replaces the stored Load. Call this function after other code has changed positions or box, if
  /// the forces and energies are already known.
  void replace_load(const Load& load) {
    load_ = load;
    current_ = complete_ = true;
  }

  IntegratorMemory memory() const {
    return {load_, current_, complete_, steps_, evaluations_, derivatives_, measurements_, {}};
  }
  void resume_from(const IntegratorMemory& memory) {
    load_ = memory.load;
    current_ = memory.current, complete_ = memory.complete;
    steps_ = memory.steps;
    evaluations_ = memory.evaluations, derivatives_ = memory.derivatives;
    measurements_ = memory.measurements;
  }

  const Scheme& scheme() const { return scheme_; }
  std::uint64_t steps() const { return steps_; }  ///< number of the next step
  std::uint64_t force_evaluations() const {
    return evaluations_;
  }  ///< number of force evaluations by steps
  std::uint64_t derivatives() const {
    return derivatives_;
  }  ///< number of derivative evaluations by
     ///< steps
  std::uint64_t measurements() const {
    return measurements_;
  }  ///< number of evaluations by load(), without the evaluations of steps

 private:
  /// Implements the flows of a scheme for one state.
  struct StateFlows {
    Integrator& integrator;
    State& state;
    bool energies = false;  // whether evaluations include energies

    void drift(double t) {
      integrator.drift_(state, t);
      integrator.current_ = false;
    }
    void kick(double t) {
      const Load& load = integrator.forces(state, energies);
      polhode::kick(state, integrator.bodies_, load, t, integrator.workers_);
    }
    void kick(double t, double xi_h2, Gradient gradient) {
      kick(t);
      switch (gradient) {
        case Gradient::exact:
          if constexpr (OffersDerivative<Forces>) integrator.exact_gradient_kick(state, t, xi_h2);
          break;
        case Gradient::finite_difference:
          integrator.finite_difference_kick(state, t, xi_h2);
          break;
      }
    }
    void bath(double t, StageNumber at) requires(!std::same_as<Bath, NoBath>) {
      integrator.bath_(state, t, at);
    }
  };

  void evaluate(const State& state, bool energies) {
    complete_ = energies;
    if (energies)
      forces_(state, load_);
    else
      complete_ = forces_alone(forces_, state, load_);
    current_ = true;
  }

  /// Adds the gradient term ξ h² ∇W to the momenta, by which e^{B̂(ξ)t} differs from e^{Bt}
  /// [vanzon2008, Eq. 5]. ∇W is twice the derivative of f and τ along the displacement that
  /// gradient_direction() returns (docs/theory.md, Eq. (14)). h is the full step, whatever the
  /// fraction of the kick.
  void exact_gradient_kick(State& state, double t, double xi_h2) {
    gradient_direction(state, bodies_, load_, dq_, dtheta_, workers_);
    forces_.directional_derivative(state, dq_, dtheta_, gradient_load_);
    ++derivatives_;
    kick(state, bodies_, gradient_load_, t * 2 * xi_h2, workers_);
  }

  /// Adds the gradient kick by finite difference: Δf = [f(q̃, S̃) − f(q, S)]/λ, and similarly for
  /// τ, both in the lab frame [vanzon2008, Eqs. 6 and 7].
  void finite_difference_kick(State& state, double t, double xi_h2) {
    shifted_.q = state.q;
    shifted_.orientation = state.orientation;
    shifted_.box = state.box;
    displace(shifted_, bodies_, load_, 2 * lambda_ * xi_h2, workers_);
    forces_alone(forces_, shifted_, gradient_load_);
    ++evaluations_;
    kick(state, bodies_, gradient_load_, t / lambda_, workers_);
    kick(state, bodies_, load_, -t / lambda_, workers_);
  }

  Scheme scheme_;
  const Bodies& bodies_;
  Forces& forces_;
  Drift drift_;
  Bath bath_;
  double lambda_;
  Workers& workers_;
  std::size_t after_last_drift_ = 0;  // number of stages up to and including the last drift
  Load load_, gradient_load_;
  Vec3Column dq_, dtheta_;  // displacement along which the derivative is taken
  State shifted_;           // displaced state q̃, S̃
  bool current_ = false;    // whether load_ belongs to the current positions
  bool complete_ = false;   // whether load_ includes energies
  std::uint64_t steps_ = 0, evaluations_ = 0, derivatives_ = 0, measurements_ = 0;
};

}  // namespace polhode
