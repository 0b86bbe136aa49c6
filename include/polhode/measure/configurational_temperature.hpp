// SPDX-License-Identifier: MIT
// Configurational temperatures, from the forces and their derivative only (docs/theory.md,
// "Equipartition").
#pragma once

#include <array>
#include <optional>
#include <span>

#include "polhode/forces/force_field.hpp"
#include "polhode/math/fit.hpp"
#include "polhode/math/random.hpp"
#include "polhode/measure/squared_force.hpp"

namespace polhode {

/// One sample. For each kind of motion, k_B T is the ratio of the means of the two quantities.
struct ConfigurationalSample {
  ByMotion<double> squared_force{};  ///< contributions to W [kJ/mol/ps²]
  ByMotion<double> curvature{};      ///< tr M⁻¹∇∇V of each kind, unbiased estimate [1/ps²]
};

/// Costs one directional derivative of the forces, along a displacement of all bodies with random
/// signs (hutchinson1990), for which cross terms average to zero.
/// @param load    at the positions of the state
/// @param random  independent for each sample and each run
ConfigurationalSample configurational_sample(const State& state, const Bodies& bodies,
                                             const Load& load, ForceField& forces, Random random);

/// T = ⟨squared_force⟩/(k_B ⟨curvature⟩) for each kind of motion (jepps2000) [K], with standard
/// errors by the jackknife over blocks of time; empty without samples, and for motions without
/// forces.
ByMotion<std::optional<Estimate>> configurational_temperatures(
    std::span<const ConfigurationalSample> samples);

/// The values only [K], 0 for motions without forces; empty without samples.
std::optional<ByMotion<double>> configurational_values(
    std::span<const ConfigurationalSample> samples);

}  // namespace polhode
