// SPDX-License-Identifier: MIT
// How far apart samples of a series must be to be independent.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace polhode {

/// The integrated autocorrelation time of a stationary series [samples]: τ = 1/2 + Σ ρ(t) over
/// t ≥ 1, so that n samples are as good as n/(2τ) independent ones; 1/2 for independent samples.
struct AutocorrelationTime {
  double value = 0;
  double error = 0;        ///< standard error, from the series itself [wolff2004, Eq. 42]
  std::size_t window = 0;  ///< lags that were summed
};

/// From the autocovariance of the series about its own mean, summed over a window that balances
/// the error of the sum and what lies beyond, and corrected for the variance of that mean
/// [wolff2004, Eqs. 49, 51 and 52 with S = 1.5].
/// @return  nothing with fewer than 10 samples, for a constant series, or where the series is
///          shorter than four windows or 10 τ
std::optional<AutocorrelationTime> autocorrelation_time(std::span<const double> series);

/// The same from independent runs of one process, about their common mean [wolff2004, Eq. 31].
/// Short runs need it: about the mean of each, what is slower than a run does not appear.
/// @return  nothing with fewer than 10 samples or two windows in the shortest run, for constant
///          series, or where all runs together are shorter than four windows or 10 τ
std::optional<AutocorrelationTime> autocorrelation_time(
    std::span<const std::span<const double>> runs);

}  // namespace polhode
