// SPDX-License-Identifier: MIT
#include "polhode/measure/fluctuation.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace polhode {
namespace {

// Long enough that neighbouring block means are nearly independent in runs of a few ps and more,
// and as many as leave a useful estimate of their scatter.
constexpr std::size_t blocks = 20;

std::vector<double> totals(std::span<const Energies> samples) {
  std::vector<double> e;
  for (const Energies& s : samples) e.push_back(s.total());
  return e;
}

std::vector<double> times(std::span<const Energies> samples) {
  std::vector<double> t;
  for (const Energies& s : samples) t.push_back(s.time);
  return t;
}

}  // namespace

Estimate block_mean(std::span<const double> values) {
  const std::size_t length = values.size() / blocks;
  if (length == 0) return mean(values);
  std::vector<double> means;
  for (std::size_t k = 0; k < blocks; ++k)
    means.push_back(mean(values.subspan(k * length, length)).value);
  return {mean(values).value, mean(means).error};
}

double fluctuation(std::span<const double> values) {
  const double average = mean(values).value;
  double squares = 0;
  for (const double v : values) squares += (v - average) * (v - average);
  return std::sqrt(squares / static_cast<double>(values.size()));
}

double fluctuation_ratio(std::span<const Energies> samples) {
  std::vector<double> v;
  for (const Energies& s : samples) v.push_back(s.potential());
  return fluctuation(totals(samples)) / fluctuation(v);
}

Estimate fluctuation_ratio_with_error(std::span<const Energies> samples) {
  const std::size_t n = std::min(blocks, samples.size() / 2);
  Estimate R{fluctuation_ratio(samples), 0};
  if (n < 3) return R;
  std::vector<double> without;
  for (std::size_t b = 0; b < n; ++b) {
    std::vector<Energies> rest(
        samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(samples.size() * b / n));
    rest.insert(rest.end(),
                samples.begin() + static_cast<std::ptrdiff_t>(samples.size() * (b + 1) / n),
                samples.end());
    without.push_back(fluctuation_ratio(rest));
  }
  R.error = jackknife_error(without);
  return R;
}

double drift_rate(std::span<const Energies> samples) {
  return slope(times(samples), totals(samples)).value;
}

Drift drift(std::span<const Energies> samples) { return drift(times(samples), totals(samples)); }

Drift drift(std::span<const double> t, std::span<const double> e) {
  const std::size_t n = std::min(blocks, e.size());
  if (n < 3) return {};
  std::vector<double> t_mean, e_mean;
  for (std::size_t b = 0; b < n; ++b) {
    const std::size_t first = e.size() * b / n, end = e.size() * (b + 1) / n;
    t_mean.push_back(mean(t.subspan(first, end - first)).value);
    e_mean.push_back(mean(e.subspan(first, end - first)).value);
  }
  const Estimate rate = slope(t_mean, e_mean);
  return {rate, chance(rate, static_cast<double>(n - 2))};
}

Drift drift_of_series(std::span<const double> rates) {
  const Estimate rate = mean(rates);
  if (rates.size() < 2) return {rate, 1};
  return {rate, chance(rate, static_cast<double>(rates.size() - 1))};
}

}  // namespace polhode
