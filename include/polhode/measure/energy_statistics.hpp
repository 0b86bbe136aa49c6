// SPDX-License-Identifier: MIT
// Statistics of the energies along a trajectory, in memory of constant size.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "polhode/measure/configurational_temperature.hpp"
#include "polhode/measure/energy.hpp"
#include "polhode/measure/shadow.hpp"
#include "polhode/measure/slope.hpp"
#include "polhode/measure/step_bias.hpp"

namespace polhode {

/// Mean kinetic temperatures of each kind of motion [K] with standard errors; 0 without degrees of
/// freedom.
struct TemperatureEstimates {
  SeriesEstimate all, translation;
  std::array<SeriesEstimate, 3> rotation;  ///< temperature of rotation about each principal axis
  SeriesEstimate rotation_all{};           ///< temperature of rotation about all axes
  SeriesEstimate difference{};             ///< T of rotation minus T of translation
};

/// Sums over the samples of a trajectory, in blocks of time. Energies are summed relative to the
/// first sample, so that squares of small fluctuations do not lose digits.
struct EnergyStatistics {
  std::uint64_t samples = 0;
  Energies first{};
  TimeBlocks blocks;

  EnergyStatistics() = default;
  explicit EnergyStatistics(std::span<const Energies> samples);

  void add(const Energies& now);

  double total() const;                  ///< mean of the total energy [kJ/mol]
  double potential() const;              ///< mean of the potential energy [kJ/mol]
  double total_fluctuation() const;      ///< rms deviation of the conserved energy [kJ/mol]
  double potential_fluctuation() const;  ///< rms deviation of the potential [kJ/mol]
  /// The ratio R: the rms fluctuation of the conserved energy divided by the rms fluctuation of the
  /// potential energy [vanzon2008]. At constant energy, the conserved energy is the total energy. R
  /// is NaN if the potential energy is constant.
  double ratio() const;
  Temperatures temperatures(
      const DegreesOfFreedom& degrees_of_freedom) const;  ///< mean temperatures [K]

  /// The ratio R with its standard error. The error includes the scatter of slow modes of the
  /// conserved energy.
  SeriesEstimate ratio_with_error() const;
  SeriesEstimate total_with_error() const;              ///< mean of the total energy [kJ/mol]
  SeriesEstimate potential_with_error() const;          ///< mean of the potential energy [kJ/mol]
  SeriesEstimate total_fluctuation_with_error() const;  ///< rms deviation of the conserved energy
                                                        ///< [kJ/mol]
  SeriesEstimate potential_fluctuation_with_error() const;  ///< rms deviation of the potential
                                                            ///< energy [kJ/mol]
  /// The integrated autocorrelation time of the potential energy [samples].
  SeriesEstimate correlation_time_of_potential() const;
  TemperatureEstimates temperatures_with_errors(const DegreesOfFreedom& degrees_of_freedom) const;
  /// The mean pressure [kJ/mol/nm³] with its standard error.
  SeriesEstimate pressure() const;
  SeriesEstimate volume() const;                    ///< mean volume [nm³]
  SeriesEstimate inverse_volume() const;            ///< mean of 1/V [1/nm³]
  SeriesEstimate relative_volume_variance() const;  ///< variance of V divided by its mean [nm³]
  Drift volume_drift() const;                       ///< slope of the volume in time [nm³/ps]
  /// The drift of the conserved energy [kJ/mol/ps].
  /// @param walks  possible variances per time of the random walk of the energy [(kJ/mol)²/ps]
  Drift drift(std::span<const WalkStrength> walks = {}) const;
  /// The drift of a conserved energy that performs a random walk of unknown strength [kJ/mol/ps].
  /// @param known  variance per time of another random walk, whose strength is known [(kJ/mol)²/ps]
  Drift drift_over_walk(double known) const;
  /// The slope of the potential energy [kJ/mol/ps], tested as a drift.
  Drift potential_drift() const;
  /// Number of samples until both the potential energy and the volume are stationary [clark2024].
  /// The number is a multiple of the block size, and 0 with few blocks.
  double samples_before_equilibrium() const;
};

/// Statistics of R over consecutive parts of a trajectory. All parts have the same length.
struct StretchStatistics {
  std::uint64_t samples = 0;     ///< number of samples in the current part
  std::array<double, 4> sums{};  ///< sums of the total energy, the potential energy and their
                                 ///< squares in the current part
  std::uint64_t stretches = 0;
  double mean = 0, squares = 0;  ///< mean of R over the parts, and sum of squared deviations of R
                                 ///< from this mean

  /// @param first   first sample of the trajectory
  /// @param length  number of samples in a part
  void add(const Energies& now, const Energies& first, std::uint64_t length);
  /// The mean of R with its standard error; empty with fewer than two parts.
  std::optional<Estimate> ratio() const;
};

/// Statistics of the samples of a trajectory. The samples themselves are not stored.
struct TrajectoryStatistics {
  EnergyStatistics energies;
  ShadowStatistics shadow;
  /// Statistics of the momenta on which a bath within the steps acts; empty without such a bath.
  EnergyStatistics at_bath;
  StepBiasStatistics step_bias;  ///< empty if fixed_means() is empty
  ConfigurationalStatistics configurational;
  StretchStatistics stretches;
};

}  // namespace polhode
