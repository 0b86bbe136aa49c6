// SPDX-License-Identifier: MIT
#include "polhode/measure/correlated_series.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
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
    root_of_weight_ = normalize();
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
    norm_ = normalize();
    ++degree_;
    return c;
  }

  /// The root of Σ w (t − t̄)², once the mean is subtracted: a slope is the next coefficient divided
  /// by it.
  double spread() const { return norm_ * root_of_weight_; }

  /// The degree of the next polynomial.
  std::size_t degree() const { return degree_; }

  /// The number of coefficients from degree() on.
  double left() const { return static_cast<double>(rest_.size() - degree_); }
  /// The sum of their squares.
  double squares_above() const { return product(rest_, rest_); }

 private:
  double product(const std::vector<double>& a, const std::vector<double>& b) const {
    double sum = 0;
    for (std::size_t k = 0; k < a.size(); ++k) sum += weights_[k] * a[k] * b[k];
    return sum;
  }
  double normalize() {
    const double norm = std::sqrt(product(current_, current_));
    for (double& x : current_) x /= norm;
    return norm;
  }

  std::vector<double> weights_, times_, rest_, last_, current_;
  double norm_ = 1, root_of_weight_;
  std::size_t degree_ = 0;
};

/// What a random walk adds to the square of the mode of degree k ≥ 1, divided by its variance at
/// the end of the run and by the number of samples.
double walk_power(double k) { return 1 / (2 * (2 * k - 1) * (2 * k + 3)); }
/// The same divided by that of the slope's mode.
double walk_share(double k) { return walk_power(k) / walk_power(1); }

/// Number of modes that determine the noise of a mean: the slowest ones, twice as many if the noise
/// is white.
constexpr std::size_t slowest = 4;
/// Limits of the mean square of the slowest modes divided by that of all faster ones, and the
/// growth of the noise towards the next slower mode with that ratio (docs/statistics.md).
constexpr double white = 1.5, too_slow = 10, growth = 0.113;

/// The noise of one mode, from those above it.
struct Noise {
  double variance = 0;
  Known known = Known::yes;
  double modes = 0;  ///< from which it was estimated
};

/// @param modes  after subtraction of those that are estimated
/// @param walk   what a random walk adds to the square of the mode of degree 1
Noise noise(Modes modes, double walk = 0) {
  double squares = 0, count = 0;
  const auto take = [&] {
    for (std::size_t k = 0; k < slowest; ++k, ++count) {
      const auto degree = static_cast<double>(modes.degree());
      squares += std::pow(modes.next(), 2) - walk * walk_share(degree);
    }
    return std::max(0.0, squares / count);
  };
  const double slow = take();
  double walks = 0, left = 0;
  for (auto k = static_cast<double>(modes.degree()); left < modes.left(); ++k, ++left)
    walks += walk * walk_share(k);
  const double all = modes.squares_above();
  const double fast = std::max(all / 10, all - walks) / modes.left();
  if (slow > too_slow * fast) return {.known = Known::too_short};
  if (slow <= white * fast) return {take(), Known::yes, count};
  return {slow * (1 + growth * (slow / fast - 1)), Known::yes, count};
}

/// A hypothesis about the noise: the variance of the modes, up to a common factor.
struct Spectrum {
  double prior = 0;      ///< probability
  double amplitude = 0;  ///< of the correlated part, relative to white noise
  double time = 0;  ///< its correlation time divided by the length of the run; infinite for a walk

  /// For the mode of degree k; a walk is given by its share of the slope's variance.
  double power(double k) const {
    return 1 + amplitude * (std::isinf(time) ? walk_share(k)
                                             : 1 / (1 + std::pow(std::numbers::pi * k * time, 2)));
  }
};

/// White noise with an exponentially correlated part (docs/statistics.md).
std::vector<Spectrum> correlated_noise() {
  constexpr std::array times{1.0 / 64, 1.0 / 32, 1.0 / 16, 1.0 / 8, 1.0 / 4};
  constexpr std::array amplitudes{1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0};
  constexpr double white_noise = 0.4;
  std::vector<Spectrum> all{{white_noise}};
  for (const double time : times)
    for (const double amplitude : amplitudes)
      all.push_back({(1 - white_noise) / (times.size() * amplitudes.size()), amplitude, time});
  return all;
}

/// White noise with a random walk, by what the walk adds to the variance of the slope.
std::vector<Spectrum> walking_noise() {
  std::vector<Spectrum> all;
  for (const double strength :
       {0.0, 1.0, 3.0, 10.0, 30.0, 100.0, 300.0, 1000.0, 3000.0, 10000.0, 30000.0})
    all.push_back({1.0 / 11, strength, std::numeric_limits<double>::infinity()});
  return all;
}

/// Neighbouring modes, whose squares are added up.
struct ModeGroup {
  double first = 0, end = 0;  ///< degrees
  double squares = 0;         ///< sum of their squared coefficients

  double modes() const { return end - first; }
  template <class F>
  double mean(F&& f) const {
    double sum = 0;
    for (double k = first; k < end; ++k) sum += f(k);
    return sum / modes();
  }
};

/// The modes that were not subtracted: each of the slowest by itself, all faster ones together.
std::vector<ModeGroup> mode_groups(Modes modes, std::size_t blocks) {
  constexpr std::size_t by_itself = 12;
  std::vector<ModeGroup> groups;
  while (groups.size() < by_itself && modes.degree() < blocks) {
    const auto k = static_cast<double>(modes.degree());
    groups.push_back({k, k + 1, std::pow(modes.next(), 2)});
  }
  if (modes.degree() < blocks)
    groups.push_back(
        {static_cast<double>(modes.degree()), static_cast<double>(blocks), modes.squares_above()});
  return groups;
}

/// A spectrum with its posterior probability and its result for the estimated mode.
struct Hypothesis {
  Spectrum spectrum;
  double probability = 0;
  double white = 0;               ///< variance of the white noise in each mode
  double variance = 0;            ///< of the estimated mode
  double degrees_of_freedom = 0;  ///< of this variance
};

/// One spectrum plus a walk of known strength, before normalization.
/// @param walk   contribution of that walk to the square of the slope's coefficient
/// @param scale  sum of squares of all modes, to which the likelihood is relative
Hypothesis hypothesis(const std::vector<ModeGroup>& groups, const Spectrum& spectrum, double degree,
                      double walk, double scale) {
  constexpr int iterations = 20;
  constexpr double min_share = 1e-3;  // of white noise in the fastest modes
  double modes = 0, white = groups.back().squares / groups.back().modes(), log_likelihood = 0;
  const double floor = std::max(min_share * white, std::numeric_limits<double>::min());
  const auto known = [&](double k) { return walk > 0 ? walk * walk_share(k) : 0.0; };
  std::vector<std::array<double, 2>> powers;  // of each group: of the spectrum, of the known walk
  for (const ModeGroup& g : groups) {
    modes += g.modes();
    powers.push_back({g.mean([&](double k) { return spectrum.power(k); }), g.mean(known)});
  }
  for (int n = 0; n < (walk > 0 ? iterations : 1); ++n) {
    double squares = 0;
    log_likelihood = 0;
    for (std::size_t i = 0; i < groups.size(); ++i) {
      const double power = powers[i][0] + (walk > 0 ? powers[i][1] / std::max(white, floor) : 0.0);
      squares += groups[i].squares / power;
      log_likelihood -= groups[i].modes() * std::log(power) / 2;
    }
    white = squares / modes;
    if (squares > 0) log_likelihood -= modes * std::log(squares / scale) / 2;
  }
  const double own = std::max(white, walk > 0 ? floor : 0.0) * spectrum.power(degree);
  const double all = own + known(degree);
  return {spectrum, spectrum.prior * std::exp(log_likelihood), white, all,
          own > 0 ? modes * std::pow(all / own, 2) : modes};
}

/// The posterior of all spectra, averaged over the strengths of a walk that is known independently.
/// @param degree  of the estimated mode
/// @param unit    c₁² of a walk of rate 1
std::vector<Hypothesis> posterior(const std::vector<ModeGroup>& groups,
                                  const std::vector<Spectrum>& spectra, double degree,
                                  std::span<const WalkStrength> walks = {}, double unit = 0) {
  constexpr WalkStrength none{};
  if (walks.empty()) walks = {&none, 1};
  double scale = std::numeric_limits<double>::min(), sum = 0;
  for (const ModeGroup& g : groups) scale += g.squares;
  std::vector<Hypothesis> all;
  for (const WalkStrength& walk : walks)
    for (const Spectrum& spectrum : spectra) {
      all.push_back(hypothesis(groups, spectrum, degree, walk.rate * unit, scale));
      sum += all.back().probability *= walk.probability;
    }
  for (Hypothesis& h : all) h.probability /= sum;
  return all;
}

/// The posterior mean of the variance of the estimated mode; its scale has an inverse χ²
/// distribution.
double mean_variance(const std::vector<Hypothesis>& all) {
  double variance = 0;
  for (const Hypothesis& h : all)
    variance += h.probability * h.variance * h.degrees_of_freedom / (h.degrees_of_freedom - 2);
  return variance;
}

/// The slope of a quantity over a run, and the modes above it.
struct Slope {
  std::size_t blocks = 0;
  double samples = 0, length = 0;  ///< length [time]
  double rate = 0;                 ///< 0 with fewer than two blocks
  double spread = 0;  ///< √Σ w (t − t̄)²: the coefficient c₁ divided by the slope
  Modes modes;

  /// c₁² that a walk of variance t has: the variance of its slope is 6/(5 T).
  double walk_unit() const { return length * samples * walk_power(1); }

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

/// The energy drift with its significance, averaged over the posterior.
Drift drift_of(const Slope& slope, const std::vector<Hypothesis>& all) {
  Drift drift{{slope.rate, std::sqrt(mean_variance(all)) / slope.spread}, 0, Known::yes};
  for (const Hypothesis& h : all)
    drift.p_value += h.probability * p_value({slope.rate, std::sqrt(h.variance) / slope.spread},
                                             h.degrees_of_freedom);
  return drift;
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
  return {result.value, std::sqrt(found.variance / all.weight), found.known, found.modes};
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
  // About the mean of the run, the samples vary by the square of its error less.
  const double tau = samples * square / (2 * (variance + square));
  return {tau, tau * std::sqrt(2 / mean.modes), Known::yes, mean.modes};
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
  std::vector<WalkStrength> walks;
  for (const Hypothesis& h :
       posterior(mode_groups(std::move(slope.modes), slope.blocks), walking_noise(), 1))
    walks.push_back({h.probability, h.spectrum.amplitude * h.white / slope.walk_unit()});
  return walks;
}

Drift series_drift(const BlockMeans& blocks, std::size_t time, std::size_t quantity,
                   std::span<const WalkStrength> walks) {
  const Slope slope(blocks, time, quantity);
  if (slope.blocks < min_samples) return {{slope.rate, 0}};
  double walk = 0;
  for (const WalkStrength& w : walks) walk += w.probability * w.rate * slope.walk_unit();
  const Known known = noise(slope.modes, walk).known;
  if (known != Known::yes) return {{slope.rate, 0}, 1, known};
  return drift_of(slope, posterior(mode_groups(slope.modes, slope.blocks), correlated_noise(), 1,
                                   walks, slope.walk_unit()));
}

Drift series_drift_over_walk(const BlockMeans& blocks, std::size_t time, std::size_t quantity) {
  const Slope slope(blocks, time, quantity);
  if (slope.blocks < min_samples) return {{slope.rate, 0}};
  return drift_of(slope, posterior(mode_groups(slope.modes, slope.blocks), walking_noise(), 1));
}

}  // namespace polhode
