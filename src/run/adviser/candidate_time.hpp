// SPDX-License-Identifier: MIT
// What a candidate costs.
#pragma once

#include <functional>

#include "polhode/run/adviser/adviser.hpp"

namespace polhode {

/// Wall-clock time per simulated ps of a candidate with its step [s], all threads on one system,
/// measured for about `seconds`.
/// @param stop  true ends the measurement
double time_of(const Candidate& candidate, System system, const Config& config, double seconds,
               const std::function<bool()>& stop, Workers& workers);

}  // namespace polhode
