// SPDX-License-Identifier: MIT
// What candidates cost.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "polhode/run/adviser/adviser.hpp"

namespace polhode {

/// Measures the wall-clock time per simulated ps of all candidates with a step but without a time.
/// The conditions are the same as in the run, with all threads on one system. Schemes are
/// interleaved, so that changes of the clock rate or of the load affect all schemes equally.
/// @param seconds  approximate time for all candidates
/// @param report   receives the name of each candidate
/// @param stop     ends the measurement if it returns true
void time_candidates(std::vector<Candidate>& candidates, const System& system, const Config& config,
                     double seconds, const std::function<void(const std::string&)>& report,
                     const std::function<bool()>& stop, Workers& workers);

}  // namespace polhode
