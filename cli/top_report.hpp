// SPDX-License-Identifier: MIT
// The trajectory of a top as text and as JSON.
#pragma once

#include "polhode/run/top/top.hpp"

namespace polhode::cli {

void print_top(const TopTrajectory& top);
void print_top_json(const TopTrajectory& top);

}  // namespace polhode::cli
