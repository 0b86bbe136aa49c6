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

/// Fits a + b hᵏ to temperature differences over the usable steps of one scheme: rotation about
/// each principal axis minus translation, and configurational minus kinetic temperature for each
/// kind of motion. For h → 0 all temperatures are equal, so a measures other errors: insufficient
/// equilibration, or chance.
struct EquipartitionFit {
  static constexpr double min_free = 4;  ///< of the pooled variance: two steps of three runs
  std::string scheme;
  int order = 2;  ///< k, of the scheme; 2 if that is unknown
  /// a [K], b [K/psᵏ]; empty with fewer than two steps, fewer than `min_free` degrees of freedom,
  /// or without three steps on a line.
  std::array<std::optional<Line>, 3> axes;
  ByMotion<std::optional<Line>> configurational;  ///< likewise
};

std::vector<EquipartitionFit> equipartition(const std::vector<Curve>& curves);

}  // namespace polhode
