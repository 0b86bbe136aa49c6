// SPDX-License-Identifier: MIT
// Deviations of a scheme from equipartition: differences between kinetic and configurational
// temperatures and between translation and rotation, at each step and extrapolated to zero step.
// These differences are part of the results of studies and of the adviser.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "polhode/math/fit.hpp"
#include "polhode/run/quantities.hpp"
#include "run/study/guideline.hpp"

namespace polhode {

/// Fits a + b hᵏ to temperature differences at the usable steps h of a scheme. Differences are the
/// rotational (about each principal axis) minus the translational temperature, and the
/// configurational minus the kinetic temperature by kind of motion. For h → 0 all temperatures are
/// equal, so the constant a measures other errors, such as insufficient equilibration or chance.
struct EquipartitionFit {
  static constexpr double min_free = 4;  ///< minimum degrees of freedom of the pooled variance, as
                                         ///< for two steps with three runs each
  std::string scheme;
  int order = 2;  ///< order k of the scheme; 2 if unknown
  /// Fitted a [K] and b [K/psᵏ] for each axis. Empty for fewer than two steps, fewer than
  /// `min_free` degrees of freedom, or if no three steps lie on a line.
  std::array<std::optional<Line>, 3> axes;
  ByMotion<std::optional<Line>> configurational;  ///< fitted a and b for each kind of motion
};

std::vector<EquipartitionFit> equipartition(const std::vector<Curve>& curves);

/// The temperature differences at a point: "excess_K" is the rotational minus the translational
/// temperature for each axis; "configurational_excess_K" is the configurational minus the kinetic
/// temperature for each kind of motion.
Quantities excesses(const EfficiencyPoint& point);

/// The limits of the temperature differences for zero step: "equipartition" and "configurational",
/// each only if the limit is known.
Quantities limits(const std::vector<EquipartitionFit>& fits);

/// The temperature differences and their limits as tables by scheme and step. Empty tables are
/// omitted.
/// @param fits  fits of the curves, in the same order
Quantities temperature_tables(const std::vector<Curve>& curves,
                              const std::vector<EquipartitionFit>& fits);

}  // namespace polhode
