// SPDX-License-Identifier: MIT
#include "measure/autocorrelation_time.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace polhode {
namespace {

using Runs = std::span<const std::span<const double>>;

constexpr std::size_t min_series = 10, min_windows = 4, min_windows_of_one = 2;
constexpr double min_times = 10;

std::size_t all_samples(Runs runs) {
  std::size_t n = 0;
  for (const auto run : runs) n += run.size();
  return n;
}

std::size_t shortest(Runs runs) {
  std::size_t n = std::numeric_limits<std::size_t>::max();
  for (const auto run : runs) n = std::min(n, run.size());
  return runs.empty() ? 0 : n;
}

double mean_of(Runs runs) {
  double sum = 0;
  for (const auto run : runs)
    for (const double x : run) sum += x;
  return sum / static_cast<double>(all_samples(runs));
}

double autocovariance(Runs runs, double mean, std::size_t lag) {
  double sum = 0;
  for (const auto run : runs)
    for (std::size_t i = 0; i + lag < run.size(); ++i)
      sum += (run[i] - mean) * (run[i + lag] - mean);
  return sum / static_cast<double>(all_samples(runs) - runs.size() * lag);
}

/// Whether a longer summation window would add more noise than signal. An exponential decay of ρ(t)
/// with the time that corresponds to τ is assumed [wolff2004, Eqs. 51 and 52].
bool window_ends(double tau, std::size_t lag, double samples) {
  constexpr double S = 1.5;
  const double t = static_cast<double>(lag);
  const double decay =
      tau <= 0.5 ? 1e-9 : S / std::log((2 * tau + 1) / (2 * tau - 1));  // decay time of ρ, times S
  return std::exp(-t / decay) - decay / std::sqrt(t * samples) < 0;
}

}  // namespace

std::optional<AutocorrelationTime> autocorrelation_time(std::span<const double> series) {
  const std::array one{series};
  return autocorrelation_time(Runs(one));
}

std::optional<AutocorrelationTime> autocorrelation_time(Runs runs) {
  if (shortest(runs) < min_series) return std::nullopt;
  const double n = static_cast<double>(all_samples(runs));
  const double mean = mean_of(runs);
  const double variance = autocovariance(runs, mean, 0);
  if (!(variance > 0)) return std::nullopt;
  double tau = 0.5;
  std::size_t lag = 1;
  for (;; ++lag) {
    if (min_windows * lag >= all_samples(runs) || min_windows_of_one * lag >= shortest(runs))
      return std::nullopt;
    tau += autocovariance(runs, mean, lag) / variance;
    if (window_ends(tau, lag, n)) break;
  }
  const double w = static_cast<double>(lag);
  tau *= 1 + (2 * w + 1) / n;
  if (n < min_times * tau) return std::nullopt;
  return AutocorrelationTime{tau, tau * std::sqrt(4 / n * std::max(w + 0.5 - tau, 0.5)), lag};
}

}  // namespace polhode
