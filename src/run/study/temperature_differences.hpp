// SPDX-License-Identifier: MIT
// Differences between kinetic and configurational temperatures and between translation and
// rotation, at each step and for zero step. Temperature differences are part of the results of
// studies and of the adviser.
#pragma once

#include <vector>

#include "polhode/run/quantities.hpp"
#include "run/study/equipartition.hpp"

namespace polhode {

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
