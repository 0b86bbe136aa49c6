// SPDX-License-Identifier: MIT
// The bath of a scheme: the flow of its O stages, which controls the temperature.
#pragma once

#include <cstdint>

#include "polhode/base/workers.hpp"
#include "polhode/ensemble/langevin.hpp"
#include "polhode/integrate/step.hpp"
#include "polhode/model/degrees_of_freedom.hpp"
#include "polhode/model/ensemble_settings.hpp"
#include "polhode/model/state.hpp"

namespace polhode {

/// Applies a thermostat over a time t, for which the Maxwell distribution is stationary, and sums
/// the heat that the bodies receive. The random numbers are functions of the seed and of the stage.
/// A run that is resumed with the same heat() therefore continues bit for bit.
class Thermostat {
 public:
  /// @param topology  copied; @param bodies  kept by reference
  Thermostat(const ThermostatSettings& settings, double temperature, const Topology& topology,
             const Bodies& bodies, std::uint64_t seed, Workers& workers = Workers::serial(),
             TotalMomentum total_momentum = TotalMomentum::held);

  void operator()(State& state, double t, StageNumber at);

  /// Kinetic energies of translation and rotation [kJ/mol]. They include the motion of the centre
  /// of mass if it is free.
  struct Motions {
    double kinetic, translation, rotation;
  };

  double heat() const { return heat_; }  ///< heat given to the bodies so far [kJ/mol]
  void resume_from(double heat) { heat_ = heat; }

 private:
  // The following overloads apply each type of thermostat and return the heat that the bodies
  // receive.
  double act(const Langevin& type, State& state, double t, StageNumber at) const;
  double act(const Rescaling& type, State& state, double t, StageNumber at) const;
  double act(const SeparateRescaling& type, State& state, double t, StageNumber at) const;

  Motions motions(const State& state) const;
  /// The factor by which momenta are scaled, from the kinetic energy and the number n of degrees of
  /// freedom. The time is in units of the time constant.
  double factor(double kinetic, double n, double time, std::uint64_t stream) const;

  ThermostatSettings settings_;
  LangevinSettings langevin_;
  DegreesOfFreedom degrees_of_freedom_;
  const Bodies& bodies_;
  Workers& workers_;
  double heat_ = 0;
};

}  // namespace polhode
