// SPDX-License-Identifier: MIT
// Differences between the temperatures of translation and rotation, kinetic and configurational, as
// functions of the step and for zero step, as text.
#pragma once

#include <vector>

#include "run/study/equipartition.hpp"

namespace polhode::cli {

/// Temperature differences by scheme and step, and for zero step; prints nothing if there are none.
/// @param fits  of the curves, in the same order
void print_temperatures(const std::vector<Curve>& curves,
                        const std::vector<EquipartitionFit>& fits);

}  // namespace polhode::cli
