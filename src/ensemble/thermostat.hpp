// SPDX-License-Identifier: MIT
// The bath of a scheme: the flow O, which maintains a temperature.
#pragma once

#include <cstdint>

#include "polhode/base/workers.hpp"
#include "polhode/ensemble/langevin.hpp"
#include "polhode/integrate/step.hpp"
#include "polhode/model/degrees_of_freedom.hpp"
#include "polhode/model/ensemble_settings.hpp"
#include "polhode/model/state.hpp"

namespace polhode {

/// The bodies of a thermostat, and the settings that all types of thermostats have.
struct ThermostatBodies {
  LangevinSettings langevin;  ///< contains temperature and seed
  DegreesOfFreedom degrees_of_freedom;
  const Bodies& bodies;
  Workers& workers;
};

/// Applies a thermostat over a time t and sums the heat that the bodies receive. All thermostats
/// keep the Maxwell distribution stationary. The random numbers are functions of the seed and of
/// the stage. A run that is resumed with the same heat() therefore continues bit for bit.
class Thermostat {
 public:
  /// @param topology  copied; @param bodies  kept by reference
  Thermostat(const ThermostatSettings& settings, double temperature, const Topology& topology,
             const Bodies& bodies, std::uint64_t seed, Workers& workers = Workers::serial(),
             TotalMomentum total_momentum = TotalMomentum::held);

  void operator()(State& state, double t, StageNumber at);

  double heat() const { return heat_; }  ///< heat given to the bodies so far [kJ/mol]
  void resume_from(double heat) { heat_ = heat; }

 private:
  ThermostatSettings settings_;
  ThermostatBodies of_;
  double heat_ = 0;
};

}  // namespace polhode
