// SPDX-License-Identifier: MIT
// State points as texts.
#pragma once

#include <string_view>
#include <vector>

#include "polhode/run/properties/measure.hpp"

namespace polhode {

/// Parses state points, such as "298.15 K, 1 bar" or "298.15 K, 997 kg/m3". Either value can be a
/// range, as in "250 K to 320 K, 7 points". The default pressure is 1 bar.
/// @throws Error  if a part cannot be read; the message names it
std::vector<StatePoint> state_points(std::string_view text);

}  // namespace polhode
