// SPDX-License-Identifier: MIT
// Where a series becomes stationary: the end of equilibration, detected instead of assumed.
#pragma once

#include <cstddef>
#include <span>

namespace polhode {

/// The end of the equilibration of a series: the sample from which on the mean is most precise.
struct Equilibration {
  std::size_t start = 0;  ///< index of the first sample that is kept
  double error = 0;       ///< standard error of the mean of the samples that are kept
};

/// Finds the sample after which the mean has the smallest standard error [clark2024]. The error
/// increases with samples of the approach to equilibrium, and also if too many samples are
/// discarded. The variance of the mean is computed from autocovariances in a window of √n lags with
/// triangular weights. The last 10 % of the samples are always kept.
/// @return  the equilibration; the whole series is kept if it has fewer than 10 samples
Equilibration equilibration(std::span<const double> series);

/// The start of equilibrium in a series: the start by equilibration() if the mean of the discarded
/// samples deviates from the mean of the rest by more than four standard errors of the difference,
/// and 0 otherwise. Without this condition, samples of a stationary series are discarded because
/// they lie far from the mean. Fluctuations and errors are then too small.
std::size_t equilibrium_start(std::span<const double> series);

}  // namespace polhode
