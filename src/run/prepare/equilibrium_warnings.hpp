// SPDX-License-Identifier: MIT
// Warnings that a preparation has not reached equilibrium.
#pragma once

#include <optional>

#include "polhode/measure/slope.hpp"
#include "polhode/model/ensemble_settings.hpp"
#include "polhode/run/simulation/report/warnings.hpp"

namespace polhode {

/// A warning if the volume still changes by more than 0.5 %.
std::optional<Warning> density_warning(const Drift& slope, double length, double volume);

/// A warning if the mean pressure shows that the density will still change by more than 0.5 %.
std::optional<Warning> pressure_warning(const SeriesEstimate& pressure,
                                        const BarostatSettings& barostat);

}  // namespace polhode
