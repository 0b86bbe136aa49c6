// SPDX-License-Identifier: MIT
// The trajectory of a top as text or as JSON.
#pragma once

#include "polhode/run/top/top.hpp"

namespace polhode::cli {

void print_top(const TopTrajectory& top, bool json);

}  // namespace polhode::cli
