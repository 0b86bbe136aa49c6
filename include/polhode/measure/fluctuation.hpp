// SPDX-License-Identifier: MIT
// The measures of quality of a trajectory (vanzon2008): R, the fluctuation of the total energy over
// that of the potential energy, and the drift of the total energy.
#pragma once

#include <span>

#include "polhode/math/fit.hpp"
#include "polhode/measure/energy.hpp"

namespace polhode {

/// rms deviation from the mean.
double fluctuation(std::span<const double> values);

/// The mean of a correlated series with the standard error of the means of blocks of it.
Estimate block_mean(std::span<const double> values);

/// R: rms fluctuation of the total energy over that of the potential energy.
double fluctuation_ratio(std::span<const Energies> samples);

/// R of one trajectory with its standard error by the jackknife over blocks of it: R without one
/// block, for each block in turn.
Estimate fluctuation_ratio_with_error(std::span<const Energies> samples);

/// The slope of the total energy against time [kJ/mol/ps] by least squares over all samples.
double drift_rate(std::span<const Energies> samples);

struct Drift {
  Estimate rate;      ///< [kJ/mol/ps]
  double chance = 1;  ///< probability of such a slope without any drift
};

/// The drift of one trajectory. Neighbouring samples are correlated, so the line is fitted through
/// the means of blocks and its error taken from their scatter.
Drift drift(std::span<const Energies> samples);
/// The same of any energies [kJ/mol] at their times [ps].
Drift drift(std::span<const double> times, std::span<const double> energies);

/// The drift over a series of independent runs: the mean of their slopes and its standard error.
Drift drift_of_series(std::span<const double> rates);

/// A drift with a smaller chance counts as significant.
inline constexpr double significance = 0.01;

}  // namespace polhode
