// SPDX-License-Identifier: MIT
#include "polhode/measure/energy_statistics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "measure/equilibration.hpp"
#include "slow_modes.hpp"

namespace polhode {
namespace {

/// The columns of the sums: conserved, potential and total energy and volume relative to the first
/// sample, their squares, and the first volume divided by the volume.
enum Column : std::size_t {
  elapsed,
  conserved_,
  potential_,
  conserved_square,
  potential_square,
  pressure_,
  translation,
  rotation_1,
  rotation_2,
  rotation_3,
  energy,
  volume_,
  volume_square,
  inverse_volume_
};

double variance(std::span<const double> mean, Column value, Column square) {
  return std::max(0.0, mean[square] - mean[value] * mean[value]);
}

SeriesEstimate fluctuation(const BlockMeans& blocks, Column value, Column square) {
  return series_estimate(blocks,
                         [=](auto mean) { return std::sqrt(variance(mean, value, square)); });
}

/// The mean of a quantity, from the sum of differences to the first sample.
SeriesEstimate mean_from(double first, const BlockMeans& blocks, Column column) {
  SeriesEstimate estimate = series_estimate(blocks, [=](auto mean) { return mean[column]; });
  estimate.value += first;
  return estimate;
}

/// The kinetic energies from the block means.
Energies kinetic_energies(std::span<const double> mean) {
  return {.translation = mean[translation],
          .rotation = {mean[rotation_1], mean[rotation_2], mean[rotation_3]}};
}

/// The ratio R; NaN if the potential energy is constant.
double ratio_of(std::span<const double> mean) {
  const double potential = variance(mean, potential_, potential_square);
  return potential > 0 ? std::sqrt(variance(mean, conserved_, conserved_square) / potential)
                       : std::nan("");
}

}  // namespace

EnergyStatistics::EnergyStatistics(std::span<const Energies> all) {
  for (const Energies& e : all) add(e);
}

void EnergyStatistics::add(const Energies& now) {
  if (samples++ == 0) first = now;
  const double e = now.conserved() - first.conserved(), v = now.potential() - first.potential();
  const double V = now.volume - first.volume;
  blocks.add(std::array{now.time - first.time, e, v, e * e, v * v, now.pressure, now.translation,
                        now.rotation[0], now.rotation[1], now.rotation[2],
                        now.total() - first.total(), V, V * V,
                        now.volume > 0 ? first.volume / now.volume : 1});
}

double EnergyStatistics::total() const {
  return samples == 0 ? 0 : first.total() + blocks.means().mean()[energy];
}

double EnergyStatistics::potential() const {
  return samples == 0 ? 0 : first.potential() + blocks.means().mean()[potential_];
}

double EnergyStatistics::total_fluctuation() const {
  return samples == 0 ? 0
                      : std::sqrt(variance(blocks.means().mean(), conserved_, conserved_square));
}

double EnergyStatistics::potential_fluctuation() const {
  return samples == 0 ? 0
                      : std::sqrt(variance(blocks.means().mean(), potential_, potential_square));
}

double EnergyStatistics::ratio() const {
  return samples == 0 ? std::nan("") : ratio_of(blocks.means().mean());
}

Temperatures EnergyStatistics::temperatures(const DegreesOfFreedom& degrees_of_freedom) const {
  if (samples == 0) return {};
  return mean_temperatures(kinetic_energies(blocks.means().mean()), degrees_of_freedom);
}

// The variance of the conserved energy is the mean variance within the blocks plus Σ c²/n over the
// slow modes c. The mean variance is an ordinary average with a standard error. The coefficient c
// of a slow mode is normally distributed. The variance of c² is therefore 2 ⟨c²⟩² = 2/3 ⟨c⁴⟩.
SeriesEstimate EnergyStatistics::ratio_with_error() const {
  const BlockMeans means = blocks.means();
  if (means.blocks().size() < min_samples) return series_estimate(means, ratio_of);
  const SlowModes modes = slow_modes(means, elapsed, conserved_);
  double slow = 0, uncertain = 0;
  for (const double c : modes.values) {
    slow += c * c / modes.samples;
    uncertain += 2 * std::pow(c, 4) / 3 / (modes.samples * modes.samples);
  }
  std::vector<BlockMeans::Block> within = means.blocks();
  for (auto& [weight, sum] : within) {
    sum[conserved_square] += weight * slow - sum[conserved_] * sum[conserved_] / weight;
    sum[conserved_] = 0;
  }
  SeriesEstimate R = series_estimate(BlockMeans(std::move(within)), ratio_of);
  const double square = variance(means.mean(), conserved_, conserved_square);
  if (R.known == Known::yes && square > 0)
    R.error = std::hypot(R.error, R.value * std::sqrt(uncertain) / (2 * square));
  R.value = ratio();
  return R;
}

SeriesEstimate EnergyStatistics::total_with_error() const {
  return mean_from(first.total(), blocks.means(), energy);
}

SeriesEstimate EnergyStatistics::potential_with_error() const {
  return mean_from(first.potential(), blocks.means(), potential_);
}

SeriesEstimate EnergyStatistics::total_fluctuation_with_error() const {
  return fluctuation(blocks.means(), conserved_, conserved_square);
}

SeriesEstimate EnergyStatistics::potential_fluctuation_with_error() const {
  return fluctuation(blocks.means(), potential_, potential_square);
}

SeriesEstimate EnergyStatistics::correlation_time_of_potential() const {
  const double rms = potential_fluctuation();
  return correlation_time(potential_with_error(), rms * rms, static_cast<double>(samples));
}

TemperatureEstimates EnergyStatistics::temperatures_with_errors(const DegreesOfFreedom& n) const {
  const BlockMeans means = blocks.means();
  const auto estimate = [&](auto&& part) {
    return series_estimate(
        means, [&](auto mean) { return part(mean_temperatures(kinetic_energies(mean), n)); });
  };
  TemperatureEstimates T{estimate([](const Temperatures& t) { return t.all; }),
                         estimate([](const Temperatures& t) { return t.translation; }),
                         {}};
  for (std::size_t k = 0; k < T.rotation.size(); ++k)
    T.rotation[k] = estimate([k](const Temperatures& t) { return t.rotation[k]; });
  const double rotating = n.all() - n.translation;
  const auto rotation = [&](const Temperatures& t) {
    double sum = 0;
    for (std::size_t k = 0; k < t.rotation.size(); ++k) sum += t.rotation[k] * n.rotation[k];
    return rotating > 0 ? sum / rotating : 0;
  };
  T.rotation_all = estimate(rotation);
  T.difference = estimate([&](const Temperatures& t) { return rotation(t) - t.translation; });
  return T;
}

SeriesEstimate EnergyStatistics::pressure() const {
  return series_estimate(blocks.means(), [](auto mean) { return mean[pressure_]; });
}

SeriesEstimate EnergyStatistics::volume() const {
  return mean_from(first.volume, blocks.means(), volume_);
}

SeriesEstimate EnergyStatistics::inverse_volume() const {
  return series_estimate(blocks.means(),
                         [V = first.volume](auto mean) { return mean[inverse_volume_] / V; });
}

SeriesEstimate EnergyStatistics::relative_volume_variance() const {
  return series_estimate(blocks.means(), [V = first.volume](auto mean) {
    return variance(mean, volume_, volume_square) / (V + mean[volume_]);
  });
}

Drift EnergyStatistics::volume_drift() const {
  return series_drift(blocks.means(), elapsed, volume_);
}

Drift EnergyStatistics::drift(std::span<const WalkStrength> walks) const {
  return series_drift(blocks.means(), elapsed, conserved_, walks);
}

Drift EnergyStatistics::drift_over_walk(double known) const {
  return series_drift_over_walk(blocks.means(), elapsed, conserved_, known);
}

Drift EnergyStatistics::potential_drift() const {
  return series_drift(blocks.means(), elapsed, potential_);
}

double EnergyStatistics::samples_before_equilibrium() const {
  const BlockMeans means = blocks.means();
  std::size_t start = 0;
  for (const std::size_t column : {potential_, volume_}) {
    std::vector<double> series;
    for (const BlockMeans::Block& block : means.blocks())
      series.push_back(block.sum[column] / block.weight);
    start = std::max(start, equilibrium_start(series));
  }
  double before = 0;
  for (std::size_t k = 0; k < start; ++k) before += means.blocks()[k].weight;
  return before;
}

void StretchStatistics::add(const Energies& now, const Energies& first, std::uint64_t length) {
  const double e = now.conserved() - first.conserved(), v = now.potential() - first.potential();
  const std::array<double, 4> terms{e, v, e * e, v * v};
  for (std::size_t k = 0; k < terms.size(); ++k) sums[k] += terms[k];
  if (++samples < length) return;
  for (double& sum : sums) sum /= static_cast<double>(samples);
  const double R = std::sqrt((sums[2] - sums[0] * sums[0]) / (sums[3] - sums[1] * sums[1]));
  const double off = R - mean;
  mean += off / static_cast<double>(++stretches);
  squares += off * (R - mean);
  samples = 0, sums = {};
}

std::optional<Estimate> StretchStatistics::ratio() const {
  if (stretches < 2) return std::nullopt;
  const auto n = static_cast<double>(stretches);
  return Estimate{mean, std::sqrt(squares / (n - 1) / n)};
}

}  // namespace polhode
