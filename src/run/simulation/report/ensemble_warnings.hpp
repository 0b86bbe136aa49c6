// SPDX-License-Identifier: MIT
// What is probably wrong with a run that a thermostat, a barostat or hybrid Monte Carlo controls.
#pragma once

#include <vector>

#include "polhode/run/simulation/report/summary.hpp"
#include "polhode/run/simulation/report/warnings.hpp"

namespace polhode {

/// Warnings about the ensemble of a run. Causes are a drifting volume, too few accepted barostat
/// moves, too few or too many accepted trajectories of hybrid Monte Carlo, and a mean of
/// exp(−ΔH/kT) that is not 1 (docs/manual/ensembles.md, Warnings).
std::vector<Warning> ensemble_warnings(const RunSummary& summary);

/// The relaxation time of the volume [ps]. The time constant of cell rescaling holds for a system
/// with the compressibility of the barostat settings. A softer system relaxes more slowly.
/// @param compressibility  compressibility of the system [nm³ mol/kJ]; 0 if it is not known
double volume_relaxation(const BarostatSettings& barostat, double compressibility);

}  // namespace polhode
