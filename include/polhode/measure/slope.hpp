// SPDX-License-Identifier: MIT
// Slopes of series that are correlated in time, with their significance; random walks
// (docs/statistics.md).
#pragma once

#include <span>
#include <vector>

#include "polhode/math/fit.hpp"
#include "polhode/measure/correlated_series.hpp"

namespace polhode {

/// The energy drift of one run, or of a series of runs.
struct Drift {
  Estimate rate;  ///< error 0 unless it is known
  double p_value =
      1;  ///< probability of such a slope if there is no energy drift; 1 unless it is known
  Known known = Known::too_few_samples;
  /// Variance per time of the random walk that the quantity performs; 0 unless there is clear
  /// evidence for one.
  double walk = 0;
  bool significant() const;
};

/// An energy drift with a smaller p-value is significant.
inline constexpr double significance = 0.01;

/// The energy drift over a series of independent runs: the mean of their slopes and its standard
/// error.
Drift drift_of_series(std::span<const double> rates);

/// A possible strength of a random walk, with its probability.
struct WalkStrength {
  double probability = 1;
  double rate = 0;  ///< variance per time
};

/// The strength of a random walk under stationary noise, as the shadow energy performs it: its
/// posterior probability (docs/statistics.md). Empty with fewer than `min_samples` blocks.
std::vector<WalkStrength> walk_strengths(const BlockMeans& blocks, std::size_t time,
                                         std::size_t quantity);

/// The slope of the least-squares line through block means of a quantity against block means of
/// time. The significance is averaged over spectra of stationary noise: white, with a correlated
/// part. A series with too long correlation has no significance.
/// @param time, quantity  which of the sums
/// @param walks  variance per time that a random walk adds to the quantity, known independently,
///               or its possible values, over which the significance is averaged
Drift series_drift(const BlockMeans& blocks, std::size_t time, std::size_t quantity,
                   std::span<const WalkStrength> walks = {});

/// The slope of a quantity that performs a random walk of unknown strength under stationary noise,
/// such as a conserved energy: the significance is averaged over strengths and spectra.
/// @param known  variance per time of another walk, of known strength
Drift series_drift_over_walk(const BlockMeans& blocks, std::size_t time, std::size_t quantity,
                             double known = 0);

}  // namespace polhode
