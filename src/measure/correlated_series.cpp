// SPDX-License-Identifier: MIT
#include "polhode/measure/correlated_series.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "math/prediction.hpp"
#include "polhode/math/fit.hpp"

namespace polhode {
namespace {

/// A series of block means, from which polynomials in time are subtracted degree by degree. The
/// polynomials are orthonormal over the weighted blocks and are computed by the Stieltjes
/// recurrence.
class Modes {
 public:
  Modes(std::vector<double> weights, std::vector<double> times, std::vector<double> values)
      : weights_(std::move(weights)),
        times_(std::move(times)),
        rest_(std::move(values)),
        last_(weights_.size(), 0.0),
        current_(weights_.size(), 1.0) {
    normalize();
  }

  /// Subtracts the polynomial of the next degree, starting with 0, and returns its coefficient.
  double next() {
    const double c = product(current_, rest_);
    for (std::size_t b = 0; b < rest_.size(); ++b) rest_[b] -= c * current_[b];
    std::vector<double> shifted(current_.size());
    for (std::size_t b = 0; b < shifted.size(); ++b) shifted[b] = times_[b] * current_[b];
    const double on_current = product(shifted, current_), on_last = product(shifted, last_);
    for (std::size_t b = 0; b < shifted.size(); ++b)
      shifted[b] -= on_current * current_[b] + on_last * last_[b];
    last_ = std::exchange(current_, std::move(shifted));
    normalize();
    ++degree_;
    return c;
  }

  /// The degree of the next polynomial to subtract.
  std::size_t degree() const { return degree_; }

  /// The number of coefficients of degree() and higher.
  double left() const { return static_cast<double>(rest_.size() - degree_); }
  /// The sum of the squares of all coefficients of degree() and higher.
  double squares_above() const { return product(rest_, rest_); }

 private:
  double product(const std::vector<double>& a, const std::vector<double>& b) const {
    double sum = 0;
    for (std::size_t k = 0; k < a.size(); ++k) sum += weights_[k] * a[k] * b[k];
    return sum;
  }
  void normalize() {
    const double norm = std::sqrt(product(current_, current_));
    for (double& x : current_) x /= norm;
  }

  std::vector<double> weights_, times_, rest_, last_, current_;
  std::size_t degree_ = 0;
};

/// The number of slowest modes that determine the noise of a mean. The number of modes is doubled
/// if the noise is white.
constexpr std::size_t slowest = 4;
/// Limits of the ratio between the mean squares of the slowest modes and all faster modes. The
/// noise of the next slower mode is also estimated from this ratio (docs/statistics.md).
constexpr double white = 1.5, too_slow = 10, growth = 0.113;

/// The noise of the mean, estimated from the slowest modes.
struct Noise {
  double variance = 0;
  Known known = Known::yes;
  double modes = 0;  ///< number of modes in the estimate
};

/// Whether the means of runs differ by more than the noise within the runs, as they do if each run
/// has a separate condition, such as its volume. Without one, the answer is yes in 5 % of cases
/// with white noise, and more often with slow noise. The error is then only less precise.
/// @param between, within  sums of squares, with their degrees of freedom
bool differ(double between, double of_means, double within, double of_modes) {
  constexpr double confidence = 0.95, min_of_means = 2;  // an error from two means means nothing
  return of_means >= min_of_means && within > 0 &&
         between / of_means > f_quantile(confidence, of_means, of_modes) * within / of_modes;
}

/// Estimates the noise of the mean.
/// @param runs  runs with all of their modes; the first mode is the deviation of the run's mean
///   from the common mean
Noise noise(std::vector<Modes> runs) {
  double squares = 0, count = -1;
  for (Modes& run : runs) {
    const double deviation = run.next();
    if (runs.size() > 1) squares += std::pow(deviation, 2);
    ++count;
  }
  const double between = squares, of_means = count;
  const auto take = [&] {
    for (Modes& run : runs)
      for (std::size_t k = 0; k < slowest; ++k, ++count) squares += std::pow(run.next(), 2);
    return squares / count;
  };
  const auto faster = [&] {
    double above = 0, left = 0;
    for (const Modes& run : runs) above += run.squares_above(), left += run.left();
    return above / left;
  };
  const double slow = take(), fast = faster();
  if (differ(between, of_means, squares - between, count - of_means))
    return {between / of_means, Known::yes, of_means};
  if (slow > too_slow * fast) return {.known = Known::too_short};
  if (slow <= white * fast) return {take(), Known::yes, count};
  return {slow * (1 + growth * (slow / fast - 1)), Known::yes, count};
}

}  // namespace

std::string reason(Known known) {
  constexpr std::array reasons{"", "too few samples", "run too short", "not defined",
                               "grows with the length of the run"};  // of each Known
  return reasons[static_cast<std::size_t>(known)];
}

double three_sigma(const SeriesEstimate& estimate) {
  return three_sigma_quantile(estimate.modes) * estimate.error;
}

SeriesEstimate series_estimate(const BlockMeans& blocks,
                               const std::function<double(std::span<const double>)>& statistic) {
  return pooled_estimate(std::span(&blocks, 1), statistic);
}

SeriesEstimate pooled_estimate(std::span<const BlockMeans> runs,
                               const std::function<double(std::span<const double>)>& statistic) {
  std::vector<BlockMeans::Block> sums;
  for (const BlockMeans& run : runs)
    if (!run.empty()) sums.push_back(run.sum());
  if (sums.empty()) return {std::nan("")};
  const BlockMeans all_runs(std::move(sums));
  const BlockMeans::Block all = all_runs.sum();
  SeriesEstimate result{statistic(all_runs.mean())};
  std::vector<Modes> modes;
  std::vector<double> without(all.sum.size());
  double largest = 0;  // largest influence
  for (const BlockMeans& run : runs) {
    if (run.blocks().size() < min_samples) return result;
    std::vector<double> weights, times, influences;
    double time = 0;  // time in samples
    for (const auto& [weight, sum] : run.blocks()) {
      const double rest = all.weight - weight;
      for (std::size_t k = 0; k < without.size(); ++k) without[k] = (all.sum[k] - sum[k]) / rest;
      weights.push_back(weight);
      times.push_back(time + weight / 2);
      influences.push_back((result.value - statistic(without)) * rest / weight);
      if (!std::isfinite(influences.back())) return result;
      largest = std::max(largest, std::abs(influences.back()));
      time += weight;
    }
    modes.emplace_back(std::move(weights), std::move(times), std::move(influences));
  }
  constexpr double rounding = 1e-12;  // relative round-off of sums of a few thousand equal numbers
  if (largest <= rounding * std::abs(result.value)) return {result.value, 0, Known::yes};
  const Noise found = noise(std::move(modes));
  return {result.value, std::sqrt(found.variance / all.weight), found.known, found.modes};
}

double interval_factor(const SeriesEstimate& estimate, double probability) {
  if (estimate.modes == 0) return 0;  // of an exact value, whose error is 0
  return t_quantile((1 + probability) / 2, estimate.modes);
}

SeriesEstimate scaled(SeriesEstimate estimate, double factor) {
  estimate.value *= factor;
  estimate.error *= std::abs(factor);
  return estimate;
}

SeriesEstimate correlation_time(const SeriesEstimate& mean, double variance, double samples) {
  if (mean.known != Known::yes || !(variance > 0))
    return {std::nan(""), 0, mean.known == Known::yes ? Known::not_defined : mean.known};
  const double square = mean.error * mean.error;
  // Deviations from the mean of a run underestimate the variance by the squared error of this mean.
  const double tau = samples * square / (2 * (variance + square));
  return {tau, tau * std::sqrt(2 / mean.modes), Known::yes, mean.modes};
}

SeriesEstimate pooled_mean(std::span<const BlockMeans> runs, std::size_t quantity) {
  std::vector<BlockMeans> only;
  for (const BlockMeans& run : runs) {
    std::vector<BlockMeans::Block> blocks;
    for (const auto& [weight, sum] : run.blocks()) blocks.push_back({weight, {sum[quantity]}});
    only.emplace_back(std::move(blocks));
  }
  return pooled_estimate(only, [](auto mean) { return mean[0]; });
}

std::vector<SeriesEstimate> series_estimates(const BlockMeans& blocks) {
  std::vector<SeriesEstimate> result;
  const std::size_t quantities = blocks.empty() ? 0 : blocks.blocks().front().sum.size();
  for (std::size_t k = 0; k < quantities; ++k)
    result.push_back(pooled_mean(std::span(&blocks, 1), k));
  return result;
}

}  // namespace polhode
