// SPDX-License-Identifier: MIT
// The bias that the step gives to the averages of a run.
#pragma once

#include <array>
#include <cstddef>

#include "polhode/measure/step_response.hpp"
#include "polhode/model/degrees_of_freedom.hpp"

namespace polhode {

/// Averages with a step minus averages without its error, to leading order, h² for schemes of
/// second order. Kinetic temperatures are 0 without degrees of freedom.
struct StepBias {
  SeriesEstimate translation;          ///< temperature [K]
  SeriesEstimate rotation;             ///< temperature about all axes [K]
  std::array<SeriesEstimate, 3> axes;  ///< temperature about each principal axis [K]
  SeriesEstimate difference;           ///< T of rotation minus T of translation [K]
  SeriesEstimate potential;            ///< energy [kJ/mol]
  SeriesEstimate pressure;             ///< [kJ/mol/nm³]
  SeriesEstimate volume;               ///< [nm³]
  SeriesEstimate density;              ///< mass over volume [u/nm³]
  SeriesEstimate compressibility;      ///< bias at a mean pressure [nm³ mol/kJ]; otherwise 0
};

/// Sums over samples of the energies of a trajectory.
struct StepBiasStatistics {
  StepResponse response;

  void add(const StepError& at, const Energies& now);
  /// The bias of each average with its standard error.
  /// @param temperature  of the thermostat, for the compressibility [K]
  /// @param mass         of all molecules, for the density [u]
  StepBias bias(const DegreesOfFreedom& degrees_of_freedom, FixedMeans fixed,
                double temperature = 0, double mass = 0) const;
};

}  // namespace polhode
