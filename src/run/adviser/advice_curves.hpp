// SPDX-License-Identifier: MIT
// The adviser's runs as points of a study, for temperature tables and zero-step limits.
#pragma once

#include <vector>

#include "polhode/run/adviser/adviser.hpp"
#include "run/study/guideline.hpp"

namespace polhode {

/// The test runs of a candidate at one step, as a point of a figure.
EfficiencyPoint efficiency_point(const Candidate& candidate, const AdviserPoint& point);

/// The curves of all candidates, with points ordered by step. The curves contain the exploratory
/// and the confirming runs that the adviser considered usable.
std::vector<Curve> curves(const Advice& advice);

}  // namespace polhode
