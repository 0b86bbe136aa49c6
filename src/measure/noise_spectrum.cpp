// SPDX-License-Identifier: MIT
#include "noise_spectrum.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace polhode {
namespace {

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
  double line = 0, product = 0, values = 0;  ///< sums of line², line · value and value² over the
                                             ///< modes
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
  constexpr double min_share = 1e-3;  // smallest relevant fraction of white noise in the fastest
                                      // mode
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

}  // namespace

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

std::vector<NoiseSpectrum> walking_noise() {
  constexpr double no_walk = 0.02, first = 1, last = 1e6;
  std::vector<NoiseSpectrum> all{{no_walk}};
  for (double walk = first; walk < 2 * last; walk *= std::sqrt(10.0))
    all.push_back({1, 0, 0, walk});
  for (std::size_t k = 1; k < all.size(); ++k)
    all[k].prior = (1 - no_walk) / static_cast<double>(all.size() - 1);
  return all;
}

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

}  // namespace polhode
