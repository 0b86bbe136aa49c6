// SPDX-License-Identifier: MIT
// Deviations of a scheme from equipartition, and their extrapolation to zero step.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "polhode/math/fit.hpp"
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

}  // namespace polhode
