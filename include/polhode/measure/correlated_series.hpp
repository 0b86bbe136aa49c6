// SPDX-License-Identifier: MIT
// Statistics of quantities that are correlated in time: means with errors and slopes with their
// significance, estimated from the slowest modes of a run (docs/statistics.md).
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "polhode/math/fit.hpp"
#include "polhode/measure/block_means.hpp"

namespace polhode {

/// Whether the error can be estimated from the run.
enum class Known {
  yes,
  too_few_samples,  ///< fewer than `min_samples`
  too_short,        ///< the series is correlated over too much of the run
  not_defined       ///< the run has no such quantity
};

/// A statistic of a run with its standard error.
struct SeriesEstimate {
  double value = 0;  ///< not finite without samples
  double error = 0;  ///< 0 unless it is known
  Known known = Known::too_few_samples;
  /// Number of modes that determined the error, which is uncertain by a part 1/√(2 modes); 0 where
  /// the error is 0 or not known.
  double modes = 0;
};

/// An estimate in another unit, or of a multiple of the quantity.
SeriesEstimate scaled(SeriesEstimate estimate, double factor);

/// The energy drift of one run, or of a series of runs.
struct Drift {
  Estimate rate;  ///< error 0 unless it is known
  double p_value =
      1;  ///< probability of such a slope if there is no energy drift; 1 unless it is known
  Known known = Known::too_few_samples;
  bool significant() const;
};

/// An energy drift with a smaller p-value is significant.
inline constexpr double significance = 0.01;

/// Minimum number of blocks for an error; runs with few samples have one block per sample.
inline constexpr std::size_t min_samples = 12;

/// The energy drift over a series of independent runs: the mean of their slopes and its standard
/// error.
Drift drift_of_series(std::span<const double> rates);

/// A statistic computed from the means of all quantities, with its standard error: the influences
/// of the blocks on it are a series, whose slowest modes give the variance of its mean. The error
/// of a statistic that is constant to rounding is 0; there is no error if the statistic is
/// undefined when one of the blocks is left out.
SeriesEstimate series_estimate(const BlockMeans& blocks,
                               const std::function<double(std::span<const double>)>& statistic);

/// The integrated autocorrelation time of a stationary quantity [samples], from the error ε of its
/// mean and the variance σ² of its samples: n ε²/2σ², which makes n samples worth n/2τ independent
/// ones. Its standard error is a part √(2/modes) (docs/statistics.md).
/// @param mean      with its error
/// @param variance  of the samples about their mean
SeriesEstimate correlation_time(const SeriesEstimate& mean, double variance, double samples);

/// The mean of each quantity with its standard error.
std::vector<SeriesEstimate> series_estimates(const BlockMeans& blocks);

/// A possible strength of a random walk, with its probability.
struct WalkStrength {
  double probability = 1;
  double rate = 0;  ///< variance per time
};

/// The strength of a random walk under white noise, as the shadow energy performs it: its posterior
/// probability, given all modes above the slope (docs/statistics.md). Empty with fewer than
/// `min_samples` blocks.
std::vector<WalkStrength> walk_strengths(const BlockMeans& blocks, std::size_t time,
                                         std::size_t quantity);

/// The slope of the least-squares line through the block means of a quantity against those of the
/// time. The significance is averaged over the spectra that the noise may have: white, with a
/// correlated part.
/// @param time, quantity  which of the sums
/// @param walks  variance per time that a random walk adds to the quantity, known independently,
///               or its possible values, over which the significance is averaged
Drift series_drift(const BlockMeans& blocks, std::size_t time, std::size_t quantity,
                   std::span<const WalkStrength> walks = {});

/// The same for a quantity that performs a random walk of unknown strength under white noise, as
/// the shadow energy does: the significance is averaged over the posterior of the strength.
Drift series_drift_over_walk(const BlockMeans& blocks, std::size_t time, std::size_t quantity);

}  // namespace polhode
