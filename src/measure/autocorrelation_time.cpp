// SPDX-License-Identifier: MIT
#include "polhode/measure/autocorrelation_time.hpp"

#include <cmath>
#include <numeric>

namespace polhode {
namespace {

constexpr std::size_t min_series = 10, min_windows = 4;
constexpr double min_times = 10;

double autocovariance(std::span<const double> series, double mean, std::size_t lag) {
  double sum = 0;
  for (std::size_t i = 0; i + lag < series.size(); ++i)
    sum += (series[i] - mean) * (series[i + lag] - mean);
  return sum / static_cast<double>(series.size() - lag);
}

/// Whether a longer window adds more noise than signal, if ρ(t) falls exponentially with the time
/// that τ corresponds to [wolff2004, Eqs. 51 and 52].
bool window_ends(double tau, std::size_t lag, double samples) {
  constexpr double S = 1.5;
  const double t = static_cast<double>(lag);
  const double decay =
      tau <= 0.5 ? 1e-9 : S / std::log((2 * tau + 1) / (2 * tau - 1));  // of ρ, times S
  return std::exp(-t / decay) - decay / std::sqrt(t * samples) < 0;
}

}  // namespace

std::optional<AutocorrelationTime> autocorrelation_time(std::span<const double> series) {
  if (series.size() < min_series) return std::nullopt;
  const double n = static_cast<double>(series.size());
  const double mean = std::accumulate(series.begin(), series.end(), 0.0) / n;
  const double variance = autocovariance(series, mean, 0);
  if (!(variance > 0)) return std::nullopt;
  double tau = 0.5;
  std::size_t lag = 1;
  for (;; ++lag) {
    if (min_windows * lag >= series.size()) return std::nullopt;
    tau += autocovariance(series, mean, lag) / variance;
    if (window_ends(tau, lag, n)) break;
  }
  const double w = static_cast<double>(lag);
  tau *= 1 + (2 * w + 1) / n;
  if (n < min_times * tau) return std::nullopt;
  return AutocorrelationTime{tau, tau * std::sqrt(4 / n * std::max(w + 0.5 - tau, 0.5)), lag};
}

}  // namespace polhode
