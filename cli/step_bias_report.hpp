// SPDX-License-Identifier: MIT
// What the step has changed in the averages of a run, as text.
#pragma once

#include "polhode/run/simulation/summary.hpp"

namespace polhode::cli {

/// Prints the bias of each average and its corrected value; nothing where it is not known.
void print_step_bias(const RunSummary& summary);

}  // namespace polhode::cli
