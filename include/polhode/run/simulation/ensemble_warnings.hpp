// SPDX-License-Identifier: MIT
// What is probably wrong with a run that a thermostat, a barostat or hybrid Monte Carlo controls.
#pragma once

#include <vector>

#include "polhode/run/simulation/warnings.hpp"

namespace polhode {

/// A volume that still drifts, too few accepted moves of the barostat, too few or too many accepted
/// trajectories of hybrid Monte Carlo, and a mean of exp(−ΔH/kT) that is not 1
/// (docs/manual/ensembles.md, Warnings).
std::vector<Warning> ensemble_warnings(const RunSummary& summary);

}  // namespace polhode
