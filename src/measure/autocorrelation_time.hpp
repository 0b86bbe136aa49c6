// SPDX-License-Identifier: MIT
// The distance beyond which samples of a series are practically independent.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace polhode {

/// The integrated autocorrelation time of a stationary series [samples]: τ = 1/2 + Σ ρ(t) over t ≥
/// 1. n samples have the information of n/(2τ) independent samples. For independent samples, τ is
/// 1/2.
struct AutocorrelationTime {
  double value = 0;
  double error = 0;        ///< standard error, estimated from the series [wolff2004, Eq. 42]
  std::size_t window = 0;  ///< number of lags that were summed
};

/// Estimates the autocorrelation time of a series from the autocovariance about its mean. The sum
/// over lags ends at a window that balances the statistical error against the truncation error. The
/// result is corrected for the variance of the mean [wolff2004, Eqs. 49, 51 and 52 with S = 1.5].
/// @return  the autocorrelation time; empty with fewer than 10 samples, for a constant series, or
///   if the series is shorter than four windows or 10 τ
std::optional<AutocorrelationTime> autocorrelation_time(std::span<const double> series);

/// Estimates the autocorrelation time from independent runs of the same process, about their common
/// mean [wolff2004, Eq. 31]. Short runs require this method: a process slower than a run is
/// invisible in deviations from the run's own mean.
/// @return  the autocorrelation time; empty with fewer than 10 samples or two windows in the
///   shortest run, for constant series, or if all runs together are shorter than four windows or 10
///   τ
std::optional<AutocorrelationTime> autocorrelation_time(
    std::span<const std::span<const double>> runs);

}  // namespace polhode
