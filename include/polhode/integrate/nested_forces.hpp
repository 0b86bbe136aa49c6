// SPDX-License-Identifier: MIT
// Multiple time steps (r-RESPA) [tuckerman1992]: an outer scheme with the slow forces, whose drifts
// are steps of an inner scheme with the near forces.
#pragma once

#include "polhode/integrate/integrator.hpp"

namespace polhode {

/// A force model split as V = V_near + V_slow, for use by an outer Integrator: its forces are the
/// slow ones, i.e. all forces minus the near ones, and its drift is e^{(A + B_near)t}, carried out
/// by an inner Integrator. If both need the near forces at the same positions, they are evaluated
/// once.
/// @tparam Near  a cheap, rapidly varying part of the forces of Full
template <ForceModel Full, ForceModel Near>
class NestedForces {
 public:
  /// @param inner   the scheme for the near forces
  /// @param steps   of the inner scheme per drift
  /// @param lambda  for finite differences in the inner scheme
  NestedForces(const Scheme& inner, int steps, const Bodies& bodies, Full& full, Near& near,
               double lambda = 1e-4, Workers& workers = Workers::serial())
      : steps_(steps),
        full_(full),
        near_(near),
        inner_(inner, bodies, near, lambda, workers),
        part_(bodies.size()) {}

  /// Slow forces and torques; the energies and the virial are those of the total forces.
  void operator()(const State& state, Load& load) {
    full_(state, load);
    take_near(state, load);
  }
  /// Slow forces and torques only.
  void forces_alone(const State& state, Load& load) {
    polhode::forces_alone(full_, state, load);
    take_near(state, load);
  }
  /// The derivative of the slow forces and torques: that of all forces minus that of the near ones.
  void directional_derivative(const State& state, const Vec3Column& dq, const Vec3Column& dtheta,
                              Load& derivative) requires OffersDerivative<Full> &&
      OffersDerivative<Near> {
    full_.directional_derivative(state, dq, dtheta, derivative);
    near_.directional_derivative(state, dq, dtheta, part_);
    ++outer_derivatives_;
    subtract(derivative, part_);
  }

  /// Sets the state that the drifts advance, in case its forces are needed before the first drift,
  /// as after resume_from().
  void integrates(const State& state) { integrated_ = &state; }

  /// e^{(A + B_near)t}, approximated by the inner scheme.
  void drift(State& state, double t) {
    integrates(state);
    inner_.advance(state, t / steps_, static_cast<std::size_t>(steps_), false);
  }

  void forget() { inner_.forget(); }

  IntegratorMemory memory() const {
    IntegratorMemory memory = inner_.memory();
    memory.evaluations = near_evaluations();
    memory.derivatives = near_derivatives();
    return memory;
  }
  void resume_from(const IntegratorMemory& memory) {
    inner_.resume_from(memory);
    elsewhere_ = outer_derivatives_ = 0;
  }

  std::uint64_t near_evaluations() const { return inner_.force_evaluations() + elsewhere_; }
  std::uint64_t near_derivatives() const { return inner_.derivatives() + outer_derivatives_; }

 private:
  void take_near(const State& state, Load& load) { subtract(load, near_load(state)); }

  static void subtract(Load& all, const Load& part) {
    const auto less = [](Column<double>& a, const Column<double>& b) {
      for (std::size_t i = 0; i < a.size(); ++i) a[i] -= b[i];
    };
    for (const auto axis : {&Vec3Column::x, &Vec3Column::y, &Vec3Column::z}) {
      less(all.f.*axis, part.f.*axis);
      less(all.tau.*axis, part.tau.*axis);
    }
  }

  /// Near forces at the positions of `state`. For the state that is being integrated, those of the
  /// inner scheme are reused. A finite difference also evaluates displaced positions, which must
  /// not enter the cache of the inner scheme.
  const Load& near_load(const State& state) {
    if (&state == integrated_) return inner_.forces(state);
    polhode::forces_alone(near_, state, part_);
    ++elsewhere_;
    return part_;
  }

  int steps_;
  Full& full_;
  Near& near_;
  Integrator<Near> inner_;
  Load part_;  // of the near forces, when the inner scheme has none
  const State* integrated_ = nullptr;
  std::uint64_t elsewhere_ = 0, outer_derivatives_ = 0;
};

}  // namespace polhode
