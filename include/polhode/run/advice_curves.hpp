// SPDX-License-Identifier: MIT
// The adviser's runs as points of a study: what they tell of temperatures, and of their limit
// without a step.
#pragma once

#include <vector>

#include "polhode/run/adviser.hpp"
#include "polhode/run/guideline.hpp"

namespace polhode {

/// Runs of a candidate with one step.
EfficiencyPoint efficiency_point(const Candidate& candidate, const AdviserPoint& point);

/// A curve for each candidate: the runs that chose and those that were to confirm, by growing step,
/// as far as the adviser found them usable.
std::vector<Curve> curves(const Advice& advice);

}  // namespace polhode
