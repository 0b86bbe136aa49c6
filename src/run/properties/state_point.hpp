// SPDX-License-Identifier: MIT
// State points as texts.
#pragma once

#include <string_view>
#include <vector>

#include "polhode/run/properties/measure.hpp"

namespace polhode {

/// The points of a text: "298.15 K, 1 bar", or with a range in place of either, "250 K to 320 K, 7
/// points". Without a pressure it is 1 bar.
/// @throws Error  naming what cannot be read
std::vector<StatePoint> state_points(std::string_view text);

}  // namespace polhode
