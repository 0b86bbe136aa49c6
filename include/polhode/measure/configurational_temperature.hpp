// SPDX-License-Identifier: MIT
// Configurational temperatures, from the forces and their derivative only (docs/theory.md,
// Eq. (44)).
#pragma once

#include <optional>

#include "polhode/forces/force_field.hpp"
#include "polhode/math/random.hpp"
#include "polhode/measure/correlated_series.hpp"
#include "polhode/measure/squared_force.hpp"
#include "polhode/measure/step_response.hpp"

namespace polhode {

/// One sample for the configurational temperature. For each kind of motion, k_B T is the mean of
/// squared_force divided by the mean of curvature.
struct ConfigurationalSample {
  ByMotion<double> squared_force{};  ///< contribution of each kind of motion to W [kJ/mol/ps²]
  ByMotion<double> curvature{};  ///< unbiased estimate of tr M⁻¹∇∇V for each motion [1/ps²]
};

/// Takes a sample for the configurational temperature. The cost is one directional derivative of
/// the forces, along a displacement of all bodies with random signs [hutchinson1990]. The random
/// signs make cross terms average to zero.
/// @param load    load at the positions of the state
/// @param random  random numbers, independent for each sample and each run
ConfigurationalSample configurational_sample(const State& state, const Bodies& bodies,
                                             const Load& load, ForceField& forces, Random random);

/// Sums over samples along a trajectory, in blocks of time.
struct ConfigurationalStatistics {
  TimeBlocks blocks;
  StepResponse response;  ///< response to the time step, from samples with a known time-step error

  void add(const ConfigurationalSample& sample, const std::optional<StepError>& error = {});
  /// The configurational temperature ⟨squared_force⟩/(k_B ⟨curvature⟩) of each kind of motion
  /// [jepps2000] [K], with its standard error. The result is empty without samples, and for motions
  /// on which no forces act.
  ByMotion<std::optional<SeriesEstimate>> temperatures() const;
  /// The time-step bias of each configurational temperature [K], to leading order. The result is
  /// empty for motions on which no forces act, and if no sample has a known time-step error.
  ByMotion<std::optional<SeriesEstimate>> step_bias(double degrees_of_freedom,
                                                    FixedMeans fixed) const;
  /// The configurational temperatures without standard errors [K]. These temperatures are 0 for
  /// motions without forces, and empty without samples.
  std::optional<ByMotion<double>> values() const;
};

}  // namespace polhode
