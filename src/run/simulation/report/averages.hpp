// SPDX-License-Identifier: MIT
// The averages of a run as quantities.
#pragma once

#include "io/settings/quantity.hpp"
#include "polhode/run/quantities.hpp"
#include "polhode/run/simulation/report/summary.hpp"
#include "polhode/run/simulation/report/warnings.hpp"

namespace polhode {

/// Converts an estimate to another unit.
SeriesEstimate in_unit(const char* symbol, Dimension dimension, const SeriesEstimate& estimate);

/// The warnings as a list, and as rows of the text.
Quantities of_warnings(const std::vector<Warning>& warnings);

/// The energies, temperatures and pressure of a run, and the results of thermostat, barostat and
/// hybrid Monte Carlo.
Quantities of_averages(const RunSummary& summary);

/// The time-step bias of each average; null if it is not known.
Quantities of_step_bias(const RunSummary& summary);

}  // namespace polhode
