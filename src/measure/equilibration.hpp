// SPDX-License-Identifier: MIT
// Detects the end of equilibration, after which a series is stationary.
#pragma once

#include <cstddef>
#include <span>

namespace polhode {

/// The end of the equilibration of a series: the first sample to keep for the most precise mean.
struct Equilibration {
  std::size_t start = 0;  ///< index of the first sample that is kept
  double error = 0;       ///< standard error of the mean of the samples that are kept
};

/// Finds the first sample to keep, for which the mean of the kept samples has the smallest standard
/// error [clark2024]. The error is larger if samples from the approach to equilibrium are kept, and
/// also if too many samples are discarded. The variance of the mean is computed from
/// autocovariances in a window of √n lags with triangular weights. The last 10 % of the samples are
/// always kept.
/// @return  the equilibration; the whole series is kept if it has fewer than 10 samples
Equilibration equilibration(std::span<const double> series);

/// The start of equilibrium in a series: the sample that equilibration() finds, or 0 if this sample
/// is not significant. The sample is significant if the means before and after this sample differ
/// by more than five standard errors of the difference, or by more than four if the sample is in
/// the second half. Without this condition, samples of a
/// stationary series that happen to lie far from the mean would be discarded. Fluctuations and
/// errors would then be too small.
std::size_t equilibrium_start(std::span<const double> series);

}  // namespace polhode
