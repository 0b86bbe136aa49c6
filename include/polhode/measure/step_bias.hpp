// SPDX-License-Identifier: MIT
// The bias that the time step causes in the averages of a run.
#pragma once

#include <array>

#include "polhode/measure/step_response.hpp"
#include "polhode/model/degrees_of_freedom.hpp"

namespace polhode {

/// The time-step bias of averages: the average at the time step minus the average for a vanishing
/// step. Only the leading order is computed (h² for second-order schemes). The bias of a
/// temperature is 0 without degrees of freedom.
struct StepBias {
  SeriesEstimate translation;          ///< temperature of translation [K]
  SeriesEstimate rotation;             ///< temperature of rotation about all axes [K]
  std::array<SeriesEstimate, 3> axes;  ///< temperature of rotation about each principal axis [K]
  SeriesEstimate difference;           ///< T of rotation minus T of translation [K]
  SeriesEstimate potential;            ///< potential energy [kJ/mol]
  SeriesEstimate pressure;             ///< pressure [kJ/mol/nm³]
  SeriesEstimate volume;               ///< volume [nm³]
  SeriesEstimate density;              ///< mass over volume [u/nm³]
  SeriesEstimate compressibility;      ///< compressibility, if a barostat fixes the mean pressure
                                       ///< [nm³ mol/kJ]; otherwise 0
};

/// An average without its time-step bias. The errors of both are combined as independent: one is of
/// a mean, and the other of a covariance.
SeriesEstimate without_bias(const SeriesEstimate& average, const SeriesEstimate& bias);

/// Sums over samples of the energies of a trajectory, from which the time-step bias follows.
struct StepBiasStatistics {
  StepResponse response;

  void add(const StepError& at, const Energies& now);
  /// The time-step bias of each average with its standard error.
  /// @param temperature  temperature of the thermostat, for the compressibility [K]
  /// @param mass         mass of all molecules, for the density [u]
  StepBias bias(const DegreesOfFreedom& degrees_of_freedom, FixedMeans fixed,
                double temperature = 0, double mass = 0) const;
};

}  // namespace polhode
