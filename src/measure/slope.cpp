// SPDX-License-Identifier: MIT
#include "polhode/measure/slope.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "slow_modes.hpp"

namespace polhode {
namespace {

/// A hypothesis about the noise: the variances of the modes, up to a common factor.
struct NoiseSpectrum {
  double prior = 0;      ///< prior probability
  double amplitude = 0;  ///< amplitude of the correlated noise, relative to white noise
  double time = 0;       ///< correlation time of this noise, divided by the length of the run
  double walk = 0;       ///< variance of a random walk in the slowest mode, relative to white noise
};

/// A spectrum with its posterior probability and the resulting slope.
struct Hypothesis {
  double probability = 0;
  double walk = 0;                ///< variance per time of the random walk of the spectrum
  double slope = 0, error = 0;    ///< slope of the least-squares line weighted by the spectrum, and
                                  ///< its error
  double degrees_of_freedom = 0;  ///< degrees of freedom of `error`
  double variance = 0;            ///< variance of the slope of the least-squares line without
                                  ///< weights
};

/// The variance of each mode in a spectrum, relative to the variance for white noise.
std::vector<double> powers(const NoiseSpectrum& spectrum, const SlowModes& modes) {
  std::vector<double> power(modes.count());
  for (std::size_t k = 0; k < power.size(); ++k)
    power[k] =
        1 +
        spectrum.amplitude / (1 + modes.wave_number_squared(k) * spectrum.time * spectrum.time) +
        spectrum.walk * modes.walk[k] / modes.walk[0];
  return power;
}

/// Sums over the modes, in which each mode is divided by its variance relative to white noise.
struct WeightedSums {
  double line = 0, product = 0, values = 0;  ///< sums of line², line · value and value²
  double log_variances = 0;

  WeightedSums(const SlowModes& modes, const std::vector<double>& power, double known) {
    double variances = 1;
    for (std::size_t k = 0; k < power.size(); ++k) {
      const double variance = power[k] + known * modes.walk[k];
      line += modes.line[k] * modes.line[k] / variance;
      product += modes.line[k] * modes.values[k] / variance;
      values += modes.values[k] * modes.values[k] / variance;
      variances *= variance;  // the product of 40 modes, each below 1e5
      if (variances > 1e200) log_variances += std::log(std::exchange(variances, 1.0));
    }
    log_variances += std::log(variances);
  }
  /// The weighted sum of squared deviations from the fitted line.
  double residual() const { return std::max(0.0, values - product * product / line); }
};

/// The hypothesis that the noise has a given spectrum plus a random walk of known strength; its
/// probability is not normalized yet.
/// @param known  variance per time of the known random walk
/// @param scale  sum of squares of all modes, to which the likelihood is relative
Hypothesis hypothesis(const SlowModes& modes, const NoiseSpectrum& spectrum, double known,
                      double scale) {
  constexpr int iterations = 20;
  constexpr double precision = 0.01;
  constexpr double min_share = 1e-3;  // smallest relevant share of white noise in the fastest mode
  const std::vector<double> power = powers(spectrum, modes);
  const auto degrees_of_freedom = static_cast<double>(modes.count() - 1);
  const double floor = std::max(min_share * scale / static_cast<double>(modes.count()) *
                                    std::min(1.0, modes.walk.back() / modes.walk[0]),
                                std::numeric_limits<double>::min());
  double white = scale / static_cast<double>(modes.count());
  WeightedSums sums(modes, power, known / std::max(white, floor));
  for (int n = 0; n < iterations; ++n) {
    const double last = std::exchange(white, sums.residual() / degrees_of_freedom);
    if (known == 0 || std::abs(white - last) <= precision * white) break;
    sums = WeightedSums(modes, power, known / std::max(white, floor));
  }
  white = std::max(white, floor);
  double own = 0, variance = 0;  // variance of the weighted slope due to the spectrum, and variance
                                 // of the plain slope
  for (std::size_t k = 0; k < power.size(); ++k) {
    const double all = power[k] + known * modes.walk[k] / white;
    own += modes.line[k] * modes.line[k] * power[k] / (all * all);
    variance += modes.line[k] * modes.line[k] * all * white;
  }
  const double line = modes.line_squared(), share = own / sums.line;
  return {spectrum.prior * std::exp(-(sums.log_variances + std::log(sums.line) +
                                      degrees_of_freedom * std::log(white / scale)) /
                                    2),
          spectrum.walk * white / modes.walk[0],
          sums.product / sums.line,
          std::sqrt(white / sums.line),
          degrees_of_freedom / (share * share),
          variance / (line * line)};
}

/// Spectra of white noise plus exponentially correlated noise.
std::vector<NoiseSpectrum> stationary_noise() {
  constexpr std::array times{1.0 / 64, 1.0 / 32, 1.0 / 16, 1.0 / 8, 1.0 / 4};
  constexpr std::array amplitudes{1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0};
  constexpr double white_noise = 0.4;
  std::vector<NoiseSpectrum> all{{white_noise}};
  for (const double time : times)
    for (const double amplitude : amplitudes)
      all.push_back({(1 - white_noise) / (times.size() * amplitudes.size()), amplitude, time});
  return all;
}

/// Spectra of white noise plus a random walk of any strength. Noise that is correlated over a part
/// of the run cannot be distinguished from a random walk, which makes the slope more uncertain.
std::vector<NoiseSpectrum> walking_noise() {
  constexpr double no_walk = 0.02, first = 1, last = 1e6;
  std::vector<NoiseSpectrum> all{{no_walk}};
  for (double walk = first; walk < 2 * last; walk *= std::sqrt(10.0))
    all.push_back({1, 0, 0, walk});
  for (std::size_t k = 1; k < all.size(); ++k)
    all[k].prior = (1 - no_walk) / static_cast<double>(all.size() - 1);
  return all;
}

/// The posterior of each spectrum combined with each random walk in `walks`. The walks have prior
/// probabilities.
std::vector<Hypothesis> posterior(const SlowModes& modes, const std::vector<NoiseSpectrum>& spectra,
                                  std::span<const WalkStrength> walks) {
  constexpr WalkStrength none{};
  if (walks.empty()) walks = {&none, 1};
  double scale = std::numeric_limits<double>::min(), sum = 0;
  for (const double value : modes.values) scale += value * value;
  std::vector<Hypothesis> all;
  for (const WalkStrength& walk : walks)
    for (const NoiseSpectrum& spectrum : spectra) {
      all.push_back(hypothesis(modes, spectrum, walk.rate, scale));
      sum += all.back().probability *= walk.probability;
    }
  for (Hypothesis& h : all) h.probability /= sum;
  return all;
}

/// The Bayes factor for a random walk. The factor is the probability of the modes with a random
/// walk of unknown strength, divided by the probability with stationary noise.
/// @param walks  as in posterior()
double evidence_of_walk(const SlowModes& modes, std::span<const WalkStrength> walks) {
  std::vector<NoiseSpectrum> spectra = stationary_noise();
  const std::size_t stationary = spectra.size();
  for (const NoiseSpectrum& spectrum : walking_noise())
    if (spectrum.walk > 0) spectra.push_back(spectrum);
  double walking = 0, other = std::numeric_limits<double>::min(), prior = 0;
  const std::vector<Hypothesis> all = posterior(modes, spectra, walks);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool walks_too = i % spectra.size() >= stationary;
    (walks_too ? walking : other) += all[i].probability;
    if (i < spectra.size() && walks_too) prior += spectra[i].prior;
  }
  return walking / other / prior;
}

/// A random walk is reported if it is more probable than stationary noise by at least the factor
/// `clear_evidence`.
constexpr double clear_evidence = 3;

/// The energy drift with its significance, averaged over the posterior.
Drift drift_of(const SlowModes& modes, const std::vector<Hypothesis>& all) {
  Drift drift{{modes.slope(), 0}, 1, Known::yes};
  double variance = 0, above = 0, below = 0;
  for (const Hypothesis& h : all) {
    if (h.probability < 1e-12) continue;
    const double n = h.degrees_of_freedom;
    variance += h.probability * h.variance * n / (n - 2);
    const double tail = p_value({h.slope, h.error}, n) / 2;
    above += h.probability * (h.slope > 0 ? tail : 1 - tail);
    below += h.probability * (h.slope > 0 ? 1 - tail : tail);
  }
  drift.rate.error = std::sqrt(variance);
  drift.p_value = std::min(1.0, 2 * std::min(above, below));
  return drift;
}

/// The posterior mean of the variance per time of a random walk; 0 if there is none.
double mean_walk(const std::vector<Hypothesis>& all) {
  double walking = 0, walk = 0;
  for (const Hypothesis& h : all)
    if (h.walk > 0) walking += h.probability, walk += h.probability * h.walk;
  return walking > 0 ? walk / walking : 0;
}

/// Whether the noise of the slope cannot be extrapolated from the modes, because the slowest modes
/// about the line are much stronger than all faster modes (docs/statistics.md).
bool too_slow(const SlowModes& modes, double walk) {
  constexpr double limit = 10;
  constexpr std::size_t first = 1, end = 5;  // modes next to the mode that a line resembles most
  const double slope = modes.slope();
  double slow = 0, fast = 0, fast_walk = 0;
  for (std::size_t k = first; k < modes.count(); ++k) {
    const double square = std::pow(modes.values[k] - slope * modes.line[k], 2);
    if (k < end) {
      slow += square - walk * modes.walk[k];
    } else {
      fast += square;
      fast_walk += walk * modes.walk[k];
    }
  }
  fast = std::max(fast / 10, fast - fast_walk);
  return slow / static_cast<double>(end - first) >
         limit * fast / static_cast<double>(modes.count() - end);
}

}  // namespace

bool Drift::significant() const { return known == Known::yes && p_value < significance; }

Drift drift_of_series(std::span<const double> rates) {
  const Estimate rate = mean(rates);
  if (rates.size() < 2) return {rate};
  return {rate, p_value(rate, static_cast<double>(rates.size() - 1)), Known::yes};
}

std::vector<WalkStrength> walk_strengths(const BlockMeans& blocks, std::size_t time,
                                         std::size_t quantity) {
  const SlowModes modes = slow_modes(blocks, time, quantity);
  if (blocks.blocks().size() < min_samples || modes.count() == 0) return {};
  const std::vector<NoiseSpectrum> spectra = walking_noise();
  const std::vector<Hypothesis> all = posterior(modes, spectra, {});
  std::map<double, WalkStrength> walks;  // strengths of walks, by strength relative to white noise
  for (std::size_t i = 0; i < all.size(); ++i) {
    WalkStrength& walk = walks.try_emplace(spectra[i].walk, WalkStrength{0, 0}).first->second;
    walk.probability += all[i].probability;
    walk.rate += all[i].probability * all[i].walk;
  }
  constexpr double negligible = 1e-3;
  std::vector<WalkStrength> result;
  for (auto& [strength, walk] : walks)
    if (walk.probability > negligible)
      result.push_back({walk.probability, walk.rate / walk.probability});
  return result;
}

Drift series_drift(const BlockMeans& blocks, std::size_t time, std::size_t quantity,
                   std::span<const WalkStrength> walks) {
  const SlowModes modes = slow_modes(blocks, time, quantity);
  if (blocks.blocks().size() < min_samples || modes.count() == 0) return {{modes.slope(), 0}};
  double walk = 0;
  for (const WalkStrength& w : walks) walk += w.probability * w.rate;
  if (too_slow(modes, walk)) return {{modes.slope(), 0}, 1, Known::too_short};
  return drift_of(modes, posterior(modes, stationary_noise(), walks));
}

Drift series_drift_over_walk(const BlockMeans& blocks, std::size_t time, std::size_t quantity,
                             double known) {
  const SlowModes modes = slow_modes(blocks, time, quantity);
  if (blocks.blocks().size() < min_samples || modes.count() == 0) return {{modes.slope(), 0}};
  const WalkStrength other{1, known};
  const std::vector<Hypothesis> all = posterior(modes, walking_noise(), {&other, 1});
  Drift drift = drift_of(modes, all);
  if (evidence_of_walk(modes, {&other, 1}) > clear_evidence) drift.walk = mean_walk(all);
  return drift;
}

}  // namespace polhode
