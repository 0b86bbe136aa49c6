// SPDX-License-Identifier: MIT
// Tuned schemes as text.
#pragma once

#include "polhode/run/study/tune.hpp"

namespace polhode::cli {

void print_tuning(const TuneResult& result);

}  // namespace polhode::cli
