// SPDX-License-Identifier: MIT
// Slopes of time-correlated series and their significance, and strengths of random walks
// (docs/statistics.md).
#pragma once

#include <span>
#include <vector>

#include "polhode/math/fit.hpp"
#include "polhode/measure/correlated_series.hpp"

namespace polhode {

/// The energy drift of one run, or of a series of runs.
struct Drift {
  Estimate rate;       ///< drift rate; error 0 if not known
  double p_value = 1;  ///< probability of a slope at least this large if there is no energy drift;
                       ///< 1 if not known
  Known known = Known::too_few_samples;
  /// Variance per time of the random walk of the quantity; 0 unless there is clear evidence for a
  /// random walk.
  double walk = 0;
  bool significant() const;
};

/// The significance level: an energy drift with a smaller p-value is significant.
inline constexpr double significance = 0.01;

/// The energy drift over a series of independent runs: the mean of their slopes, with its standard
/// error.
Drift drift_of_series(std::span<const double> rates);

/// A possible strength of a random walk, with its probability.
struct WalkStrength {
  double probability = 1;
  double rate = 0;  ///< variance per time
};

/// For a series that contains a random walk and stationary noise, the posterior probability of each
/// possible strength of the random walk. An example of such a series is the shadow energy
/// (docs/statistics.md). Empty with fewer than `min_samples` blocks.
std::vector<WalkStrength> walk_strengths(const BlockMeans& blocks, std::size_t time,
                                         std::size_t quantity);

/// The slope of the least-squares line through the block means of a quantity, plotted against the
/// block means of time. The significance is averaged over spectra of stationary noise, which have a
/// white and a correlated part. If the correlation time is too long, the significance is not known.
/// @param time, quantity  indices of the two sums
/// @param walks  possible variances per time of an independently known random walk in the quantity;
///   the significance is averaged over them
Drift series_drift(const BlockMeans& blocks, std::size_t time, std::size_t quantity,
                   std::span<const WalkStrength> walks = {});

/// The slope of a quantity that performs a random walk of unknown strength under stationary noise,
/// such as a conserved energy. The significance is averaged over strengths and spectra.
/// @param known  variance per time of a second random walk of known strength
Drift series_drift_over_walk(const BlockMeans& blocks, std::size_t time, std::size_t quantity,
                             double known = 0);

}  // namespace polhode
