// SPDX-License-Identifier: MIT
// Configurational temperatures: what forces and their derivative alone tell of the temperature
// (docs/theory.md, "Equipartition").
#pragma once

#include <array>
#include <optional>

#include "polhode/forces/force_field.hpp"
#include "polhode/math/random.hpp"
#include "polhode/measure/correlated_series.hpp"
#include "polhode/measure/squared_force.hpp"

namespace polhode {

/// One look at a state. k_B T is the ratio of the means of the two, for each kind of motion.
struct ConfigurationalSample {
  ByMotion<double> squared_force{};  ///< the parts of W [kJ/mol/ps²]
  ByMotion<double> curvature{};  ///< tr M⁻¹∇∇V of each kind, estimated without bias [1/ps²]
};

/// Costs one directional derivative of the forces, along a displacement of all bodies with random
/// signs (hutchinson1990): cross terms vanish in the mean over them.
/// @param load    at the positions of the state
/// @param random  independent from sample to sample, and from run to run
ConfigurationalSample configurational_sample(const State& state, const Bodies& bodies,
                                             const Load& load, ForceField& forces, Random random);

/// Sums over samples along a trajectory, in blocks of time.
struct ConfigurationalStatistics {
  TimeBlocks blocks;

  void add(const ConfigurationalSample& sample);
  /// T = ⟨squared_force⟩/(k_B ⟨curvature⟩) of each kind of motion (jepps2000) [K], with its
  /// standard error; nothing without samples, nor for motions that feel no forces.
  ByMotion<std::optional<SeriesEstimate>> temperatures() const;
  /// Their values alone [K], 0 for motions without forces; nothing without samples.
  std::optional<ByMotion<double>> values() const;
};

}  // namespace polhode
