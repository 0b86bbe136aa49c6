// SPDX-License-Identifier: MIT
// Applies a scheme to a state: drifts and kicks in order, with forces from any callable.
#pragma once

#include <concepts>
#include <cstdint>
#include <utility>
#include <vector>

#include "polhode/base/error.hpp"
#include "polhode/base/workers.hpp"
#include "polhode/integrate/flows.hpp"
#include "polhode/integrate/scheme.hpp"

namespace polhode {

/// Anything that computes the Load at a State. Optional members: forces_alone(state, load), which
/// skips the energies when they are not needed; drift(state, t), a flow that replaces the drift, as
/// for multiple time steps; and, if that flow keeps data between steps, forget(), memory() and
/// resume_from(memory) with the same meaning as in Integrator.
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

/// What an integrator carries from step to step: an integrator that takes it over continues bitwise
/// identically.
struct IntegratorMemory {
  Load load;              ///< of the last evaluation
  bool current = false;   ///< whether it belongs to the current positions
  bool complete = false;  ///< whether it includes energies
  std::uint64_t evaluations = 0, derivatives = 0, measurements = 0;
  std::vector<IntegratorMemory> inner;  ///< of the inner scheme, if there is one
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

/// Owns its scratch space and the last Load; a step does not allocate.
template <ForceModel Forces>
class Integrator {
 public:
  /// @param forces  kept by reference
  /// @param lambda  for gradient kicks by finite difference (vanzon2008, Eq. 6)
  /// @param workers  for drifts and kicks, kept by reference; the forces have their own
  /// @throws Error  if the scheme has exact gradients and the forces offer no derivative
  Integrator(const Scheme& scheme, const Bodies& bodies, Forces& forces, double lambda = 1e-4,
             Workers& workers = Workers::serial())
      : scheme_(scheme),
        bodies_(bodies),
        forces_(forces),
        lambda_(lambda),
        workers_(workers),
        load_(bodies.size()) {
    if (scheme.has(Gradient::finite_difference)) shifted_ = State(bodies.size(), {});
    if (scheme.has(Gradient::exact)) {
      if (!OffersDerivative<Forces>)
        throw Error(
            "the scheme has exact gradient kicks and these forces have no derivative; give them a "
            "directional_derivative, or take finite differences as in \"gier4-fd\"");
      dq_ = dtheta_ = Vec3Column(bodies.size());
    }
    if (scheme.has(Gradient::finite_difference) || scheme.has(Gradient::exact))
      gradient_load_ = Load(bodies.size());
  }

  /// Advances by `steps` steps e^{Lh} (vanzon2008, Eq. 1). The last stage of a step and the first
  /// of the next are applied as one flow. At the end the state is synchronised: positions and
  /// momenta belong to the same time.
  /// @param energies  whether energies are required from load() at the end; otherwise they have to
  ///                  be computed at that point
  void advance(State& state, double h, std::size_t steps = 1, bool energies = true) {
    const std::span<const Stage> stages = scheme_.stages();
    // If the model divides each drift into a number of inner steps, two drifts cannot be merged.
    const bool mergeable = scheme_.mergeable() && (stages[0].flow == Flow::kick || !has_own_drift);
    const double start = state.time;
    for (std::size_t n = 0; n < steps; ++n) {
      const bool first = n == 0, last = n + 1 == steps;
      for (std::size_t k = 0; k < stages.size(); ++k) {
        if (mergeable && k == 0 && !first)
          continue;  // was merged with the last stage of the previous step
        Stage stage = stages[k];
        if (mergeable && k + 1 == stages.size() && !last) stage.fraction *= 2;
        apply(stage, state, h, energies && last && k + 1 == stages.size());
      }
    }
    state.time = start + static_cast<double>(steps) * h;
  }

  /// The Load at the positions of the state: that of the last kick if the positions have not
  /// changed since, otherwise a new evaluation, which is counted as a measurement rather than as
  /// part of the integration.
  const Load& load(const State& state) {
    if (!current_ || !complete_) {
      evaluate(state, load_, true);
      ++measurements_;
    }
    return load_;
  }

  /// Forces and torques at the positions of the state: those of the last kick if the positions have
  /// not changed since, otherwise a new evaluation as part of the integration.
  /// @param energies  whether a new evaluation should include energies
  const Load& forces(const State& state, bool energies = false) {
    if (!current_) {
      evaluate(state, load_, energies);
      ++evaluations_;
    }
    return load_;
  }

  /// Forces and torques of the last kick, at the positions of that kick.
  const Load& last_load() const { return load_; }

  /// To be called when the positions were changed from outside.
  void forget() {
    current_ = false;
    if constexpr (requires { forces_.forget(); }) forces_.forget();
  }

  IntegratorMemory memory() const {
    IntegratorMemory memory{load_,        current_,      complete_, evaluations_,
                            derivatives_, measurements_, {}};
    if constexpr (requires { forces_.memory(); }) memory.inner.push_back(forces_.memory());
    return memory;
  }
  void resume_from(const IntegratorMemory& memory) {
    load_ = memory.load;
    current_ = memory.current, complete_ = memory.complete;
    evaluations_ = memory.evaluations, derivatives_ = memory.derivatives;
    measurements_ = memory.measurements;
    if constexpr (requires { forces_.resume_from(memory); })
      forces_.resume_from(memory.inner.at(0));
  }

  const Scheme& scheme() const { return scheme_; }
  std::uint64_t force_evaluations() const { return evaluations_; }  ///< by steps
  std::uint64_t derivatives() const { return derivatives_; }        ///< of forces, by steps
  std::uint64_t measurements() const { return measurements_; }      ///< by load() only

 private:
  static constexpr bool has_own_drift = requires(Forces & forces, State& state, double t) {
    forces.drift(state, t);
  };

  void evaluate(const State& state, Load& load, bool energies) {
    complete_ = energies;
    if (energies)
      forces_(state, load);
    else
      complete_ = forces_alone(forces_, state, load);
    current_ = true;
  }

  void apply(const Stage& stage, State& state, double h, bool energies) {
    if (stage.flow == Flow::drift) {
      if constexpr (has_own_drift)
        forces_.drift(state, stage.fraction * h);
      else
        drift(state, bodies_, stage.fraction * h, workers_);
      current_ = false;
      return;
    }
    kick(state, bodies_, forces(state, energies), stage.fraction * h, workers_);  // f, τ
    if constexpr (OffersDerivative<Forces>)
      if (stage.has(Gradient::exact)) exact_gradient_kick(stage, state, h);
    if (stage.has(Gradient::finite_difference)) finite_difference_kick(stage, state, h);
  }

  /// The additional part of e^{B̂(ξ)} over e^B: ξ h² ∇W (vanzon2008, Eq. 5), where ∇W is twice the
  /// derivative of f and τ along the displacement that they would cause (docs/theory.md, "The
  /// gradient kick"). h in ξ h² is the full step, whatever the weight of the kick.
  void exact_gradient_kick(const Stage& stage, State& state, double h) {
    gradient_direction(state, bodies_, load_, dq_, dtheta_, workers_);
    forces_.directional_derivative(state, dq_, dtheta_, gradient_load_);
    ++derivatives_;
    kick(state, bodies_, gradient_load_, stage.fraction * h * 2 * stage.xi * h * h, workers_);
  }

  /// The same by finite difference: Δf = [f(q̃, S̃) − f(q, S)]/λ, and likewise for τ, both in the
  /// lab frame (vanzon2008, Eqs. 6 and 7).
  void finite_difference_kick(const Stage& stage, State& state, double h) {
    shifted_.q = state.q;
    shifted_.attitude = state.attitude;
    shifted_.box = state.box;
    displace(shifted_, bodies_, load_, 2 * stage.xi * lambda_ * h * h, workers_);
    const bool complete = complete_;
    evaluate(shifted_, gradient_load_, false);
    complete_ = complete;
    ++evaluations_;
    const double t = stage.fraction * h / lambda_;
    kick(state, bodies_, gradient_load_, t, workers_);
    kick(state, bodies_, load_, -t, workers_);
  }

  Scheme scheme_;
  const Bodies& bodies_;
  Forces& forces_;
  double lambda_;
  Workers& workers_;
  Load load_, gradient_load_;
  Vec3Column dq_, dtheta_;  // displacement along which the derivative is taken
  State shifted_;           // q̃, S̃
  bool current_ = false;    // load_ belongs to the current positions
  bool complete_ = false;   // load_ includes energies
  std::uint64_t evaluations_ = 0, derivatives_ = 0, measurements_ = 0;
};

}  // namespace polhode
