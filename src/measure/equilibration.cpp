// SPDX-License-Identifier: MIT
#include "measure/equilibration.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace polhode {
namespace {

constexpr std::size_t min_length = 10;

/// The squared standard error of the mean of a series.
double squared_error(std::span<const double> series) {
  const auto n = static_cast<double>(series.size());
  double mean = 0;
  for (const double x : series) mean += x / n;
  const auto covariance = [&](std::size_t lag) {
    double sum = 0;
    for (std::size_t t = lag; t < series.size(); ++t)
      sum += (series[t] - mean) * (series[t - lag] - mean);
    return sum / n;
  };
  const auto window = static_cast<std::size_t>(std::lround(std::sqrt(n)));
  const double independent = covariance(0);
  double variance = independent;
  for (std::size_t lag = 1; lag < window; ++lag)
    variance += 2 * (1 - static_cast<double>(lag) / static_cast<double>(window)) * covariance(lag);
  return std::max(variance, independent) / n;
}

}  // namespace

Equilibration equilibration(std::span<const double> series) {
  if (series.size() < min_length) return {};
  Equilibration best{0, std::numeric_limits<double>::infinity()};
  const auto last = static_cast<std::size_t>(std::lround(0.9 * static_cast<double>(series.size())));
  for (std::size_t start = 0; start <= std::min(last, series.size() - 2); ++start) {
    const double error = squared_error(series.subspan(start));
    if (error < best.error) best = {start, error};
  }
  best.error = std::sqrt(best.error);
  return best;
}

}  // namespace polhode
