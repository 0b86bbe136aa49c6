// SPDX-License-Identifier: MIT
// The slow modes of a series. Contributions of random walk, white noise and slow noise to different
// modes are uncorrelated (docs/statistics.md).
#pragma once

#include <vector>

#include "polhode/measure/block_means.hpp"

namespace polhode {

/// The slow modes of a series of block means. The modes are eigenvectors of a random walk's
/// covariance matrix, slowest first. If all blocks are equal, the modes are half cosines over the
/// run. For white noise, each coefficient has the variance of a sample. The mean is subtracted.
struct SlowModes {
  double samples = 0, length = 0;  ///< number of samples, and length of the run [time]
  std::vector<double> values;      ///< coefficients of the series
  std::vector<double> line;        ///< coefficients of the straight line whose values are the times
  std::vector<double> walk;        ///< variance of each coefficient for a random walk with variance
                                   ///< 1 per time

  std::size_t count() const { return values.size(); }
  /// The squared wave number (π k)² of mode k of equal blocks, k = 1, 2, ...
  double wave_number_squared(std::size_t k) const { return samples * length / walk[k]; }

  double line_squared() const;
  /// The slope of the least-squares line; 0 without modes.
  double slope() const;
};

/// Computes the slow modes of a series.
/// @param time, quantity  indices of the two sums
SlowModes slow_modes(const BlockMeans& blocks, std::size_t time, std::size_t quantity);

}  // namespace polhode
