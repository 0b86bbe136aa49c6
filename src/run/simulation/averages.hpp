// SPDX-License-Identifier: MIT
// The averages of a run as quantities.
#pragma once

#include "polhode/run/quantities.hpp"
#include "polhode/run/simulation/summary.hpp"

namespace polhode {

/// Energies, temperatures, pressure, and what thermostat, barostat and hybrid Monte Carlo did.
Quantities of_averages(const RunSummary& summary);

}  // namespace polhode
