// SPDX-License-Identifier: MIT
// The rms fluctuation of numbers.
#pragma once

#include <cmath>
#include <span>

namespace polhode {

/// rms deviation from the mean.
inline double fluctuation(std::span<const double> values) {
  const auto n = static_cast<double>(values.size());
  double mean = 0, squares = 0;
  for (const double v : values) mean += v / n;
  for (const double v : values) squares += (v - mean) * (v - mean);
  return std::sqrt(squares / n);
}

}  // namespace polhode
