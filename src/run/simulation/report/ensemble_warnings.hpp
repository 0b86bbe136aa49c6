// SPDX-License-Identifier: MIT
// Warnings about probable errors in runs with a thermostat, a barostat or hybrid Monte Carlo.
#pragma once

#include <vector>

#include "polhode/run/simulation/report/summary.hpp"
#include "polhode/run/simulation/report/warnings.hpp"

namespace polhode {

/// Warnings about the ensemble of a run. Causes of warnings are a drifting volume, too few accepted
/// barostat moves, too few or too many accepted trajectories of hybrid Monte Carlo, and a mean of
/// exp(−ΔH/kT) that is not 1 (docs/manual/ensembles.md, Warnings).
std::vector<Warning> ensemble_warnings(const RunSummary& summary);

/// The relaxation time of the volume [ps]. For cell rescaling, the relaxation time equals the time
/// constant if the system has the compressibility of the barostat settings. A more compressible
/// system relaxes more slowly.
/// @param compressibility  compressibility of the system [nm³ mol/kJ]; 0 if it is not known
double volume_relaxation(const BarostatSettings& barostat, double compressibility);

}  // namespace polhode
