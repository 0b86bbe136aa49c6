// SPDX-License-Identifier: MIT
#include "polhode/measure/correlated_series.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace polhode {
namespace {

/// A series of block means, from which polynomials in time are subtracted degree by degree. They
/// are orthonormal over the blocks with their weights, by the recurrence of Stieltjes.
class Modes {
 public:
  Modes(std::vector<double> weights, std::vector<double> times, std::vector<double> values)
      : weights_(std::move(weights)),
        times_(std::move(times)),
        rest_(std::move(values)),
        last_(weights_.size(), 0.0),
        current_(weights_.size(), 1.0) {
    root_of_weight_ = normalise();
  }

  /// The coefficient of the polynomial of the next degree, from 0; the polynomial is subtracted.
  double next() {
    const double c = product(current_, rest_);
    for (std::size_t b = 0; b < rest_.size(); ++b) rest_[b] -= c * current_[b];
    std::vector<double> shifted(current_.size());
    for (std::size_t b = 0; b < shifted.size(); ++b) shifted[b] = times_[b] * current_[b];
    const double on_current = product(shifted, current_), on_last = product(shifted, last_);
    for (std::size_t b = 0; b < shifted.size(); ++b)
      shifted[b] -= on_current * current_[b] + on_last * last_[b];
    last_ = std::exchange(current_, std::move(shifted));
    norm_ = normalise();
    ++degree_;
    return c;
  }

  /// The root of Σ w (t − t̄)², once the mean is subtracted: a slope is the next coefficient divided
  /// by it.
  double spread() const { return norm_ * root_of_weight_; }

  /// The degree of the next polynomial.
  std::size_t degree() const { return degree_; }

  /// Mean square of the coefficients of all degrees from degree() on.
  /// @param walk  contribution of a random walk to the sum of squares; it is subtracted, but at
  ///              least a tenth of the sum remains
  double above(double walk) const {
    const double squares = product(rest_, rest_);
    return std::max(squares / 10, squares - walk) / static_cast<double>(rest_.size() - degree_);
  }

 private:
  double product(const std::vector<double>& a, const std::vector<double>& b) const {
    double sum = 0;
    for (std::size_t k = 0; k < a.size(); ++k) sum += weights_[k] * a[k] * b[k];
    return sum;
  }
  double normalise() {
    const double norm = std::sqrt(product(current_, current_));
    for (double& x : current_) x /= norm;
    return norm;
  }

  std::vector<double> weights_, times_, rest_, last_, current_;
  double norm_ = 1, root_of_weight_;
  std::size_t degree_ = 0;
};

/// Number of modes that determine the noise: the slowest ones, twice as many if the noise is white.
constexpr std::size_t slowest = 4;
/// Limits of the mean square of the slowest modes divided by that of all faster ones, and the
/// growth of the noise towards the next slower mode with that ratio (docs/statistics.md).
constexpr double white = 1.5, too_slow = 10, growth = 0.113;

/// Contribution of a random walk to the sum of squares of all modes of degree k ≥ `first`, divided
/// by its variance at the end of the run and by the number of samples: 1/(2 (2k − 1)(2k + 3)) each.
double walk_from(double first) { return (1 / (2 * first - 1) + 1 / (2 * first + 1)) / 8; }

/// The same for one mode of degree k ≥ 1.
double walk_power(double k) { return 1 / (2 * (2 * k - 1) * (2 * k + 3)); }

/// The noise of one mode.
struct Noise {
  double variance = 0;            ///< without the walk
  double degrees_of_freedom = 0;  ///< of `all`
  double all = 0;                 ///< with the walk
  Known known = Known::yes;
};

/// @param modes  after subtraction of those that are estimated
/// @param walk   variance of a random walk at the end of the run, times the number of samples
Noise noise(Modes modes, double walk = 0) {
  const auto first = static_cast<double>(modes.degree());
  double squares = 0;
  const auto take = [&](double walks) {  // the mean square with and without the walk
    for (std::size_t k = 0; k < slowest; ++k) squares += std::pow(modes.next(), 2);
    const double count = static_cast<double>(modes.degree()) - first;
    return Noise{std::max(0.0, (squares - walk * walks) / count), count, squares / count};
  };
  const double end = first + slowest;
  Noise slow = take(walk_from(first) - walk_from(end));
  const double fast = modes.above(walk * walk_from(end));
  if (slow.variance > too_slow * fast) return {.known = Known::too_short};
  if (slow.variance <= white * fast) return take(walk_from(first) - walk_from(end + slowest));
  const double grown = 1 + growth * (slow.variance / fast - 1);
  slow.variance *= grown, slow.all *= grown;
  return slow;
}

/// The slope of a quantity over a run, and the modes above it.
struct Slope {
  std::size_t blocks = 0;
  double samples = 0, length = 0;  ///< length [time]
  double rate = 0;                 ///< 0 with fewer than two blocks
  double spread = 0;  ///< √Σ w (t − t̄)²: the coefficient c₁ divided by the slope
  Modes modes;

  Slope(const BlockMeans& means, std::size_t time, std::size_t quantity)
      : Slope(columns(means, time, quantity)) {}

 private:
  struct Columns {
    std::vector<double> weights, times, values;
  };
  static Columns columns(const BlockMeans& means, std::size_t time, std::size_t quantity) {
    Columns c;
    for (const auto& [weight, sum] : means.blocks()) {
      c.weights.push_back(weight);
      c.times.push_back(sum[time] / weight);
      c.values.push_back(sum[quantity] / weight);
    }
    return c;
  }
  explicit Slope(Columns c)
      : blocks(c.weights.size()),
        samples(std::accumulate(c.weights.begin(), c.weights.end(), 0.0)),
        modes(c.weights, c.times, c.values) {
    if (blocks < 2) return;
    const auto count = static_cast<double>(blocks);
    length = (c.times.back() - c.times.front()) * count / (count - 1);
    modes.next();  // the mean
    spread = modes.spread();
    rate = modes.next() / spread;
  }
};

/// Neighbouring modes, whose squares are added up.
struct ModeGroup {
  double modes = 0;    ///< how many
  double squares = 0;  ///< sum of their squared coefficients
  double walk = 0;     ///< what a random walk adds to each, divided by what it adds to c₁²
};

/// Each of the slowest modes by itself, all faster ones together.
std::vector<ModeGroup> mode_groups(Modes modes, std::size_t blocks) {
  constexpr std::size_t by_itself = 12;
  std::vector<ModeGroup> groups;
  while (groups.size() < by_itself && modes.degree() < blocks) {
    const double walk = walk_power(static_cast<double>(modes.degree())) / walk_power(1);
    groups.push_back({1, std::pow(modes.next(), 2), walk});
  }
  if (modes.degree() == blocks) return groups;
  const auto first = static_cast<double>(modes.degree()), end = static_cast<double>(blocks);
  const double walk = (walk_from(first) - walk_from(end)) / (end - first) / walk_power(1);
  groups.push_back({end - first, (end - first) * modes.above(0), walk});
  return groups;
}

/// The prior: variance that the walk adds to the slope, divided by that of white noise; all values
/// are equally probable.
constexpr std::array prior_strengths{0.0,   1.0,    3.0,    10.0,    30.0,   100.0,
                                     300.0, 1000.0, 3000.0, 10000.0, 30000.0};

/// Σ c_k²/(1 + strength g_k): the modes, brought to the variance of white noise.
double scaled_squares(const std::vector<ModeGroup>& groups, double strength) {
  double sum = 0;
  for (const ModeGroup& g : groups) sum += g.squares / (1 + strength * g.walk);
  return sum;
}

/// A strength of the prior with its posterior probability.
struct Posterior {
  double strength = 0, probability = 0;
  double noise = 0;  ///< variance of a mode without the walk
  double modes = 0;  ///< that determine it
};

std::vector<Posterior> posterior(const std::vector<ModeGroup>& groups) {
  const double fit =
      std::log(std::max(scaled_squares(groups, 0), std::numeric_limits<double>::min()));
  std::vector<Posterior> result;
  double sum = 0;
  for (const double strength : prior_strengths) {
    double modes = 0, log_likelihood = 0;
    const double squares = scaled_squares(groups, strength);
    for (const ModeGroup& g : groups) {
      modes += g.modes;
      log_likelihood -= g.modes * std::log(1 + strength * g.walk) / 2;
    }
    if (squares > 0) log_likelihood -= modes * (std::log(squares) - fit) / 2;
    result.push_back({strength, std::exp(log_likelihood), squares / modes, modes});
    sum += result.back().probability;
  }
  for (Posterior& p : result) p.probability /= sum;
  return result;
}

}  // namespace

bool Drift::significant() const { return known == Known::yes && p_value < significance; }

Drift drift_of_series(std::span<const double> rates) {
  const Estimate rate = mean(rates);
  if (rates.size() < 2) return {rate};
  return {rate, p_value(rate, static_cast<double>(rates.size() - 1)), Known::yes};
}

SeriesEstimate series_estimate(const BlockMeans& blocks,
                               const std::function<double(std::span<const double>)>& statistic) {
  if (blocks.empty()) return {std::nan("")};
  SeriesEstimate result{statistic(blocks.mean())};
  if (blocks.blocks().size() < min_samples) return result;
  const BlockMeans::Block all = blocks.sum();
  std::vector<double> weights, times, influences, without(all.sum.size());
  double time = 0, largest = 0;  // in samples; of the influences
  for (const auto& [weight, sum] : blocks.blocks()) {
    const double rest = all.weight - weight;
    for (std::size_t k = 0; k < without.size(); ++k) without[k] = (all.sum[k] - sum[k]) / rest;
    weights.push_back(weight);
    times.push_back(time + weight / 2);
    influences.push_back((result.value - statistic(without)) * rest / weight);
    if (!std::isfinite(influences.back())) return result;
    largest = std::max(largest, std::abs(influences.back()));
    time += weight;
  }
  constexpr double rounding = 1e-12;  // of sums of a few thousand equal numbers, relative
  if (largest <= rounding * std::abs(result.value)) return {result.value, 0, Known::yes};
  Modes modes(std::move(weights), std::move(times), std::move(influences));
  modes.next();  // the mean
  const Noise found = noise(std::move(modes));
  return {result.value, std::sqrt(found.variance / all.weight), found.known};
}

std::vector<SeriesEstimate> series_estimates(const BlockMeans& blocks) {
  std::vector<SeriesEstimate> result;
  const std::size_t quantities = blocks.empty() ? 0 : blocks.blocks().front().sum.size();
  for (std::size_t k = 0; k < quantities; ++k) {
    std::vector<BlockMeans::Block> one;
    for (const auto& [weight, sum] : blocks.blocks()) one.push_back({weight, {sum[k]}});
    result.push_back(
        series_estimate(BlockMeans(std::move(one)), [](auto mean) { return mean[0]; }));
  }
  return result;
}

std::vector<WalkStrength> walk_strengths(const BlockMeans& blocks, std::size_t time,
                                         std::size_t quantity) {
  Slope slope(blocks, time, quantity);
  if (slope.blocks < min_samples) return {};
  const double unit = slope.length * slope.samples * walk_power(1);  // c₁² of a walk of rate 1
  std::vector<WalkStrength> walks;
  for (const Posterior& p : posterior(mode_groups(std::move(slope.modes), slope.blocks)))
    walks.push_back({p.probability, p.strength * p.noise / unit});
  return walks;
}

Drift series_drift(const BlockMeans& blocks, std::size_t time, std::size_t quantity,
                   std::span<const WalkStrength> walks) {
  constexpr WalkStrength none{};
  if (walks.empty()) walks = {&none, 1};
  const Slope slope(blocks, time, quantity);
  Drift drift{{slope.rate, 0}};
  if (slope.blocks < min_samples) return drift;
  const double length = slope.length * slope.samples;
  double known = 0, variance = 0, chances = 0;
  for (const WalkStrength& walk : walks) {
    const Noise found = noise(slope.modes, walk.rate * length);
    if (found.known != Known::yes) continue;
    // A walk of variance D t has a slope of variance 6 D/(5 T).
    const double c1_squared = found.variance + walk.rate * length * walk_power(1);
    known += walk.probability;
    variance += walk.probability * c1_squared;
    chances +=
        walk.probability * p_value({slope.rate, std::sqrt(c1_squared) / slope.spread},
                                   found.degrees_of_freedom * std::pow(c1_squared / found.all, 2));
  }
  // Strengths that leave the noise unknown do not count, unless they are the more probable ones.
  drift.known = known > 0.5 ? Known::yes : Known::too_short;
  if (drift.known != Known::yes) return drift;
  drift.rate.error = std::sqrt(variance / known) / slope.spread;
  drift.p_value = chances / known;
  return drift;
}

Drift series_drift_over_walk(const BlockMeans& blocks, std::size_t time, std::size_t quantity) {
  Slope slope(blocks, time, quantity);
  Drift drift{{slope.rate, 0}};
  if (slope.blocks < min_samples) return drift;
  drift.known = Known::yes;
  double variance = 0;
  drift.p_value = 0;
  for (const Posterior& p : posterior(mode_groups(std::move(slope.modes), slope.blocks))) {
    const double c1_squared = (1 + p.strength) * p.noise;
    variance += p.probability * c1_squared * p.modes / (p.modes - 2);
    drift.p_value +=
        p.probability * p_value({slope.rate, std::sqrt(c1_squared) / slope.spread}, p.modes);
  }
  drift.rate.error = std::sqrt(variance) / slope.spread;
  return drift;
}

}  // namespace polhode
