// SPDX-License-Identifier: MIT
// Configurational temperatures, from the forces and their derivative only (docs/theory.md,
// Eq. (44)).
#pragma once

#include <array>
#include <optional>

#include "polhode/forces/force_field.hpp"
#include "polhode/math/random.hpp"
#include "polhode/measure/correlated_series.hpp"
#include "polhode/measure/squared_force.hpp"
#include "polhode/measure/step_response.hpp"

namespace polhode {

/// One sample. For each kind of motion, k_B T is the ratio of the means of the two quantities.
struct ConfigurationalSample {
  ByMotion<double> squared_force{};  ///< contributions to W [kJ/mol/ps²]
  ByMotion<double> curvature{};      ///< tr M⁻¹∇∇V of each kind, unbiased estimate [1/ps²]
};

/// Costs one directional derivative of the forces, along a displacement of all bodies with random
/// signs [hutchinson1990], for which cross terms average to zero.
/// @param load    at the positions of the state
/// @param random  independent for each sample and each run
ConfigurationalSample configurational_sample(const State& state, const Bodies& bodies,
                                             const Load& load, ForceField& forces, Random random);

/// Sums over samples along a trajectory, in blocks of time.
struct ConfigurationalStatistics {
  TimeBlocks blocks;
  StepResponse response;  ///< response at samples with a known time-step error

  void add(const ConfigurationalSample& sample, const std::optional<StepError>& error = {});
  /// T = ⟨squared_force⟩/(k_B ⟨curvature⟩) of each kind of motion [jepps2000] [K], with its
  /// standard error; nothing without samples, nor for motions that feel no forces.
  ByMotion<std::optional<SeriesEstimate>> temperatures() const;
  /// Their time-step bias [K], to leading order; empty for the same motions, and without samples
  /// with a known time-step error.
  ByMotion<std::optional<SeriesEstimate>> step_bias(double degrees_of_freedom,
                                                    FixedMeans fixed) const;
  /// Their values without errors [K], 0 for motions without forces; empty without samples.
  std::optional<ByMotion<double>> values() const;
};

}  // namespace polhode
