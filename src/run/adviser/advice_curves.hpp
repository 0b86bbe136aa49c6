// SPDX-License-Identifier: MIT
// The adviser's runs as points of a study, for their temperatures and the zero-step limits of
// those.
#pragma once

#include <vector>

#include "polhode/run/adviser/adviser.hpp"
#include "run/study/guideline.hpp"

namespace polhode {

/// The runs of a candidate with one step.
EfficiencyPoint efficiency_point(const Candidate& candidate, const AdviserPoint& point);

/// One curve per candidate, ordered by step: the exploratory runs and the confirming ones, as far
/// as the adviser considered them usable.
std::vector<Curve> curves(const Advice& advice);

}  // namespace polhode
