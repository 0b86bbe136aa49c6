// SPDX-License-Identifier: MIT
#include "polhode/measure/slope.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "noise_spectrum.hpp"

namespace polhode {
namespace {

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
