// SPDX-License-Identifier: MIT
// What thermostat, barostat and hybrid Monte Carlo did in a run, as text.
#pragma once

#include "polhode/run/simulation/summary.hpp"

namespace polhode::cli {

/// "300 K, Langevin thermostat with ...", printed before all other results; nothing at constant
/// energy.
void print_ensemble(const EnsembleSummary& summary);

/// Density, volume, compressibility, acceptance, heat and work; nothing at constant energy.
void print_ensemble_results(const RunSummary& summary);

}  // namespace polhode::cli
