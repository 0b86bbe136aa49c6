// SPDX-License-Identifier: MIT
// How far a scheme's steps are from equipartition, and what is left of it without a step.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "polhode/math/fit.hpp"
#include "polhode/run/guideline.hpp"

namespace polhode {

/// Fits differences of temperatures, a + b hᵏ, over the usable steps of one scheme: of rotation
/// about each principal axis less translation, and of the configurational temperature of each
/// motion less its kinetic one. Without a step all are equal, so a measures what else is wrong:
/// starts out of equilibrium, chance.
struct EquipartitionFit {
  std::string scheme;
  int order = 2;                            ///< k, of the scheme; 2 where it is unknown
  std::array<std::optional<Line>, 3> axes;  ///< a [K], b [K/psᵏ]; nothing with fewer than two steps
  ByMotion<std::optional<Line>> configurational;  ///< likewise
};

std::vector<EquipartitionFit> equipartition(const std::vector<Curve>& curves);

}  // namespace polhode
