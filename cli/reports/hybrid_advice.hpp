// SPDX-License-Identifier: MIT
// polhode advise --ensemble nvt: advice for hybrid Monte Carlo, which has no bias to bound.
#pragma once

#include "run/canonical/hybrid_adviser.hpp"

namespace polhode::cli {

/// Finds the step and the trajectory length, and prints them.
/// @return  the exit code
/// @throws Error     as advise_hybrid()
/// @throws RunError  if no choice has runs long enough
int advise_hybrid(const HybridAdviserSettings& settings, const Config& config, bool json,
                  Workers& workers);

}  // namespace polhode::cli
