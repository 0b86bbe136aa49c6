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

/// Whether the standard error can be estimated from the run, and if not, why.
enum class Known {
  yes,
  too_few_samples,  ///< fewer than `min_samples`
  too_short,        ///< the correlation time is too large a fraction of the run
  not_defined,      ///< the run does not have this quantity
  grows             ///< the statistic grows without limit, because a random walk contributes to it
};

/// The reason why a standard error is not known: "too few samples", "run too short" or "not
/// defined". If the error is known, the text is empty.
std::string reason(Known known);

/// A statistic of a run, with its standard error.
struct SeriesEstimate {
  double value = 0;  ///< the statistic; not finite without samples
  double error = 0;  ///< standard error; 0 if it is not known
  Known known = Known::too_few_samples;
  /// Number of modes from which the standard error was computed; 0 if the error is 0 or not known.
  /// The relative uncertainty of the error is 1/√(2 modes).
  double modes = 0;
};

/// Multiplies an estimate and its error by a factor, for example to change the unit.
SeriesEstimate scaled(SeriesEstimate estimate, double factor);

/// The smallest number of blocks from which an error is estimated. In runs with few samples, each
/// sample is a block.
inline constexpr std::size_t min_samples = 12;

/// The deviation from the true value that a statistic exceeds in 0.27 % of runs. This deviation
/// corresponds to three standard deviations of a normal distribution. The deviation is computed
/// from Student's t distribution, because the error is estimated from a few modes. If the number of
/// modes is not known, the deviation is three standard errors.
double three_sigma(const SeriesEstimate& estimate);

/// Computes a statistic from the means of all quantities, with its standard error. The jackknife
/// influences of the blocks form a series. The slowest modes of this series give the variance of
/// the mean. A statistic that is constant to round-off has the error 0. The error is not known if
/// the statistic is undefined after one block is left out.
SeriesEstimate series_estimate(const BlockMeans& blocks,
                               const std::function<double(std::span<const double>)>& statistic);

/// Computes a statistic from independent runs of the same system, such as replicas, with its
/// standard error. The modes of all runs together give the error. For each run, the deviation of
/// its mean from the common mean counts as one more mode.
SeriesEstimate pooled_estimate(std::span<const BlockMeans> runs,
                               const std::function<double(std::span<const double>)>& statistic);

/// The mean of one of the quantities of independent runs, with its standard error.
SeriesEstimate pooled_mean(std::span<const BlockMeans> runs, std::size_t quantity);

/// The multiple of the standard error that bounds the deviation from the true value with a given
/// probability. Student's t distribution with `modes` degrees of freedom is used.
double interval_factor(const SeriesEstimate& estimate, double probability);

/// The integrated autocorrelation time τ = n ε²/2σ² of a stationary quantity [samples]. τ is
/// computed from the error ε of the mean and the variance σ² of the n samples. The n samples
/// contain as much information as n/2τ independent samples. The relative standard error of τ is
/// √(2/modes) (docs/statistics.md).
/// @param mean      mean with its error
/// @param variance  variance of the samples about their mean
SeriesEstimate correlation_time(const SeriesEstimate& mean, double variance, double samples);

/// The mean of each quantity with its standard error.
std::vector<SeriesEstimate> series_estimates(const BlockMeans& blocks);

}  // namespace polhode
