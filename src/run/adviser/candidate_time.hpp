// SPDX-License-Identifier: MIT
// What candidates cost.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "polhode/run/adviser/adviser.hpp"

namespace polhode {

/// Measures the wall-clock time per simulated ps of the candidates that have a step and no time
/// yet, under the conditions of the run: all threads on one system, schemes interleaved, so that
/// changes of the clock rate or of the load affect all schemes equally.
/// @param seconds  for all candidates, about
/// @param report   gets the name of each candidate
/// @param stop     true ends the measurement
void time_candidates(std::vector<Candidate>& candidates, const System& system, const Config& config,
                     double seconds, const std::function<void(const std::string&)>& report,
                     const std::function<bool()>& stop, Workers& workers);

}  // namespace polhode
