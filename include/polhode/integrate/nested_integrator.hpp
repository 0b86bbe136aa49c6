// SPDX-License-Identifier: MIT
// Multiple time steps (r-RESPA) [tuckerman1992]: an outer scheme applies the slow forces. Each
// drift of the outer scheme consists of steps of an inner scheme, which applies the near forces.
#pragma once

#include "polhode/integrate/integrator.hpp"
#include "polhode/integrate/nested_scheme.hpp"

namespace polhode {

/// The flow e^{(A + B_near)t}, approximated by a number of steps of an inner integrator.
template <class Inner>
struct InnerSteps {
  Inner& inner;
  int steps = 1;
  void operator()(State& state, double t) const {
    inner.advance(state, t / steps, static_cast<std::size_t>(steps), false);
  }
};

/// Computes the slow forces of V = V_near + V_slow, which are the total forces minus the near
/// forces. At the current positions of the integrated state, the inner and the outer integrator
/// share one evaluation of the near forces.
/// @tparam Near  a cheap, rapidly varying part of the forces of Full
template <ForceModel Full, ForceModel Near>
class SlowForces {
 public:
  SlowForces(Full& full, Near& near, Integrator<Near>& inner, std::size_t bodies)
      : full_(full), near_(near), inner_(inner), part_(bodies) {}

  /// Computes slow forces and torques. The result contains the energies and the virial of the total
  /// forces.
  void operator()(const State& state, Load& load) {
    full_(state, load);
    subtract(load, near_load(state));
  }
  /// Computes only the slow forces and torques.
  void forces_alone(const State& state, Load& load) {
    polhode::forces_alone(full_, state, load);
    subtract(load, near_load(state));
  }
  /// Computes the derivative of the slow forces and torques: the derivative of the total forces
  /// minus the derivative of the near forces.
  void directional_derivative(const State& state, const Vec3Column& dq, const Vec3Column& dtheta,
                              Load& derivative) requires OffersDerivative<Full> &&
      OffersDerivative<Near> {
    full_.directional_derivative(state, dq, dtheta, derivative);
    near_.directional_derivative(state, dq, dtheta, part_);
    ++near_derivatives_;
    subtract(derivative, part_);
  }

  /// Sets the state that the inner integrator advances. Evaluations at any other state, such as the
  /// displaced state of a finite difference, must not affect the memory of the inner integrator.
  void integrates(const State& state) { integrated_ = &state; }

  /// Number of near-force evaluations outside the inner integrator.
  std::uint64_t near_evaluations() const { return near_evaluations_; }
  std::uint64_t near_derivatives() const { return near_derivatives_; }
  void reset_counts() { near_evaluations_ = near_derivatives_ = 0; }

 private:
  static void subtract(Load& all, const Load& part) {
    const auto less = [](Component& a, const Component& b) {
      for (std::size_t i = 0; i < a.size(); ++i) a[i] -= b[i];
    };
    for (const auto axis : {&Vec3Column::x, &Vec3Column::y, &Vec3Column::z}) {
      less(all.f.*axis, part.f.*axis);
      less(all.tau.*axis, part.tau.*axis);
    }
  }

  const Load& near_load(const State& state) {
    if (&state == integrated_) return inner_.forces(state);
    polhode::forces_alone(near_, state, part_);
    ++near_evaluations_;
    return part_;
  }

  Full& full_;
  Near& near_;
  Integrator<Near>& inner_;
  Load part_;  // load of the near forces, if the inner integrator has none
  const State* integrated_ = nullptr;
  std::uint64_t near_evaluations_ = 0, near_derivatives_ = 0;
};

/// Integrates the motion with an outer and an inner scheme. The outer Integrator applies the slow
/// forces. An inner Integrator with the near forces performs the drifts.
template <ForceModel Full, ForceModel Near, StateBath Bath = NoBath>
class NestedIntegrator {
 public:
  /// @param scheme  scheme with an inner scheme
  /// @param full, near  total and near forces, kept by reference
  /// @param bath  bath of the outer scheme; the inner scheme has none
  /// @throws Error  under the same conditions as Integrator
  NestedIntegrator(const NestedScheme& scheme, const Bodies& bodies, Full& full, Near& near,
                   double lambda = 1e-4, Workers& workers = Workers::serial(), Bath bath = {})
      : inner_(scheme.inner.value().scheme, bodies, near, lambda, workers),
        slow_(full, near, inner_, bodies.size()),
        outer_(scheme.outer, bodies, slow_,
               InnerSteps<Integrator<Near>>{inner_, scheme.inner->steps}, std::move(bath), lambda,
               workers) {}
  NestedIntegrator(const NestedIntegrator&) = delete;
  NestedIntegrator& operator=(const NestedIntegrator&) = delete;

  void advance(State& state, double h, std::size_t steps = 1, bool energies = true) {
    slow_.integrates(state);
    outer_.advance(state, h, steps, energies);
  }

  /// The slow forces, with the energies and the virial of the total forces.
  const Load& load(const State& state) {
    slow_.integrates(state);
    return outer_.load(state);
  }
  const Load& last_load() const { return outer_.last_load(); }
  SlowForces<Full, Near>& slow_forces() { return slow_; }

  /// Discards stored loads. Call this function after other code has changed the positions.
  void forget() { inner_.forget(), outer_.forget(); }
  void replace_load(const Load&) {
    forget();
  }  // the near and slow parts of this Load are not
     // known

  IntegratorMemory memory() const {
    IntegratorMemory memory = outer_.memory();
    IntegratorMemory& inner = memory.inner.emplace_back(inner_.memory());
    inner.evaluations = near_evaluations();
    inner.derivatives = near_derivatives();
    return memory;
  }
  /// @param memory  has no memory of an inner scheme if the previous scheme had no inner scheme
  void resume_from(const IntegratorMemory& memory) {
    outer_.resume_from(memory);
    if (memory.inner.empty())
      inner_.forget();
    else
      inner_.resume_from(memory.inner.front());
    slow_.reset_counts();
  }

  std::uint64_t force_evaluations() const {
    return outer_.force_evaluations();
  }  ///< number of evaluations of all forces
  std::uint64_t derivatives() const { return outer_.derivatives(); }
  std::uint64_t measurements() const { return outer_.measurements(); }
  std::uint64_t near_evaluations() const {
    return inner_.force_evaluations() + slow_.near_evaluations();
  }
  std::uint64_t near_derivatives() const { return inner_.derivatives() + slow_.near_derivatives(); }

 private:
  Integrator<Near> inner_;
  SlowForces<Full, Near> slow_;
  Integrator<SlowForces<Full, Near>, InnerSteps<Integrator<Near>>, Bath> outer_;
};

}  // namespace polhode
