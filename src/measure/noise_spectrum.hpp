// SPDX-License-Identifier: MIT
// Hypotheses about the noise of a series, each with its estimate of the slope (docs/statistics.md).
#pragma once

#include <span>
#include <vector>

#include "polhode/measure/slope.hpp"
#include "slow_modes.hpp"

namespace polhode {

/// A hypothesis about the noise: the variances of the modes, up to a common factor.
struct NoiseSpectrum {
  double prior = 0;      ///< prior probability
  double amplitude = 0;  ///< amplitude of the correlated noise, relative to white noise
  double time = 0;       ///< correlation time of the correlated noise, divided by the length of the
                         ///< run
  double walk = 0;       ///< variance of a random walk in the slowest mode, relative to white noise
};

/// Spectra of white noise plus exponentially correlated noise.
std::vector<NoiseSpectrum> stationary_noise();
/// Spectra of white noise plus a random walk of any strength. Noise that is correlated over a part
/// of the run cannot be distinguished from a random walk, which makes the slope more uncertain.
std::vector<NoiseSpectrum> walking_noise();

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

/// The posterior of each spectrum combined with each random walk in `walks`. The walks have prior
/// probabilities.
std::vector<Hypothesis> posterior(const SlowModes& modes, const std::vector<NoiseSpectrum>& spectra,
                                  std::span<const WalkStrength> walks);

/// The Bayes factor for a random walk. The factor is the probability of the modes with a random
/// walk of unknown strength, divided by the probability with stationary noise.
/// @param walks  as in posterior()
double evidence_of_walk(const SlowModes& modes, std::span<const WalkStrength> walks);

}  // namespace polhode
