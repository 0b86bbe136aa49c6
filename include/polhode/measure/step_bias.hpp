// SPDX-License-Identifier: MIT
// The bias that the step gives to averages over a trajectory, from the trajectory itself
// (docs/theory.md, Eqs. (47) to (49)).
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "polhode/integrate/scheme.hpp"
#include "polhode/measure/correlated_series.hpp"
#include "polhode/measure/energy.hpp"
#include "polhode/model/degrees_of_freedom.hpp"
#include "polhode/model/ensemble_settings.hpp"

namespace polhode {

/// What two trajectories with different steps have in common when their averages are compared.
enum class FixedMeans {
  energy,                      ///< constant energy: that of the total energy
  kinetic_energy,              ///< rescaling thermostat: that of the kinetic energy
  kinetic_energy_and_pressure  ///< with a barostat: those of both
};

/// Nothing where the distribution is not that of a shadow energy: with a Langevin thermostat, with
/// translation and rotation thermostatted apart, with a bath within the steps; and nothing where
/// there is no bias: hybrid Monte Carlo.
std::optional<FixedMeans> fixed_means(const EnsembleSettings& settings, const Scheme& scheme);

/// Averages with a step minus those without its error, to leading order: h² with schemes of second
/// order. Kinetic temperatures are those of motions, 0 without degrees of freedom.
struct StepBias {
  SeriesEstimate translation;          ///< temperature [K]
  SeriesEstimate rotation;             ///< temperature about all axes [K]
  std::array<SeriesEstimate, 3> axes;  ///< temperature about each principal axis [K]
  SeriesEstimate difference;           ///< temperature of rotation minus that of translation [K]
  SeriesEstimate potential;            ///< energy [kJ/mol]
  SeriesEstimate pressure;             ///< [kJ/mol/nm³]
  SeriesEstimate volume;               ///< [nm³]
};

/// Sums over samples of a trajectory, in blocks of time, relative to the first sample.
struct StepBiasStatistics {
  std::uint64_t samples = 0;
  Energies first{};
  double first_error = 0;
  TimeBlocks blocks;

  /// @param error  of the energy that the scheme conserves, H̃ − H, up to a constant [kJ/mol]
  void add(const Energies& now, double error);
  /// Each with its standard error.
  StepBias bias(const DegreesOfFreedom& degrees_of_freedom, FixedMeans fixed) const;
};

}  // namespace polhode
