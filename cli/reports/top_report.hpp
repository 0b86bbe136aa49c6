// SPDX-License-Identifier: MIT
// The trajectory of a top as text.
#pragma once

#include "polhode/run/top/top.hpp"

namespace polhode::cli {

void print_top(const TopTrajectory& top);

}  // namespace polhode::cli
