// SPDX-License-Identifier: MIT
// Statistics of quantities that are correlated in time, with errors estimated from the slowest
// modes of a run (docs/statistics.md).
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "polhode/measure/block_means.hpp"

namespace polhode {

/// Whether the error can be estimated from the run.
enum class Known {
  yes,
  too_few_samples,  ///< fewer than `min_samples`
  too_short,        ///< the series is correlated over too much of the run
  not_defined,      ///< the run has no such quantity
  grows             ///< the statistic has no limit: a random walk makes it grow with the run
};

/// Why an error is not known: "too few samples", "run too short" or "not defined"; empty if it is.
std::string reason(Known known);

/// A statistic of a run with its standard error.
struct SeriesEstimate {
  double value = 0;  ///< the statistic; not finite without samples
  double error = 0;  ///< 0 unless it is known
  Known known = Known::too_few_samples;
  /// Number of modes that determined the error, whose relative uncertainty is 1/√(2 modes); 0 if
  /// the error is 0 or not known.
  double modes = 0;
};

/// An estimate in another unit, or of a multiple of the quantity.
SeriesEstimate scaled(SeriesEstimate estimate, double factor);

/// Minimum number of blocks for an error; runs with few samples have one block per sample.
inline constexpr std::size_t min_samples = 12;

/// The deviation from its true value that a statistic with a known error exceeds in 0.27 % of runs,
/// as a normal distribution exceeds three standard deviations. It uses Student's t, because the
/// error is estimated from a few modes; without their number it is three errors.
double three_sigma(const SeriesEstimate& estimate);

/// A statistic computed from the means of all quantities, with its standard error. The jackknife
/// influences of the blocks are a series, whose slowest modes give the variance of its mean. The
/// error of a statistic that is constant to rounding is 0. There is no error if the statistic is
/// undefined without one of the blocks.
SeriesEstimate series_estimate(const BlockMeans& blocks,
                               const std::function<double(std::span<const double>)>& statistic);

/// A statistic of independent runs of one process, such as replicas, with its standard error. The
/// modes of all runs together give the error. The deviation of each run's mean from the common mean
/// is a mode as well.
SeriesEstimate pooled_estimate(std::span<const BlockMeans> runs,
                               const std::function<double(std::span<const double>)>& statistic);

/// The multiple of the error within which the true value lies with a probability, by Student's t
/// with `modes` degrees of freedom.
double interval_factor(const SeriesEstimate& estimate, double probability);

/// The integrated autocorrelation time τ = n ε²/2σ² of a stationary quantity [samples], from the
/// error ε of its mean and the variance σ² of its samples. n samples are worth n/2τ independent
/// samples. Its relative standard error is √(2/modes) (docs/statistics.md).
/// @param mean      with its error
/// @param variance  of the samples about their mean
SeriesEstimate correlation_time(const SeriesEstimate& mean, double variance, double samples);

/// The mean of each quantity with its standard error.
std::vector<SeriesEstimate> series_estimates(const BlockMeans& blocks);

}  // namespace polhode
