// SPDX-License-Identifier: MIT
#include "polhode/measure/step_response.hpp"

#include <cmath>

namespace polhode {
namespace {

/// Each sample adds to these sums: the factors, the averaged quantities, and the products of each
/// factor with all averaged quantities. The first averaged quantities are the kinetic energy and
/// the pressure.
constexpr std::size_t error_factor = 0, total_factor = 1, volume_factor = 2, factors = 3;
constexpr std::size_t kinetic_mean = 0, pressure_mean = 1, other_means = 2;

/// The time-step shift of each average, from the means of the sums.
class Shifts {
 public:
  Shifts(std::span<const double> mean, const std::vector<double>& first, double degrees_of_freedom,
         FixedMeans fixed)
      : mean_(mean), averages_(first.size() - factors) {
    const double K = first[factors + kinetic_mean] + mean[factors + kinetic_mean];
    kT_ = 2 * K / degrees_of_freedom;
    if (fixed != FixedMeans::energy) warmer_ = covariance(error_factor, kinetic_mean) / (kT_ * K);
    if (fixed != FixedMeans::energy && fixed != FixedMeans::kinetic_energy)
      pressure_ = (*this)(pressure_mean);
  }

  double operator()(std::size_t a) const {
    return (-covariance(error_factor, a) + warmer_ * covariance(total_factor, a) +
            pressure_ * covariance(volume_factor, a)) /
           kT_;
  }

 private:
  double covariance(std::size_t factor, std::size_t a) const {
    return mean_[factors + averages_ + factor * averages_ + a] - mean_[factor] * mean_[factors + a];
  }

  std::span<const double> mean_;
  std::size_t averages_;
  double kT_ = 0;
  double warmer_ = 0;    // relative shift of T that removes the shift of the kinetic energy
  double pressure_ = 0;  // bias of the pressure at constant volume, to which the volume responds
};

/// The time-step bias of a function of averages: its derivative along the shifts of the averages.
double bias_at(std::span<const double> mean, const std::vector<double>& first, const Shifts& shifts,
               const StepResponse::Function& f) {
  std::vector<double> above, below;
  for (std::size_t k = factors + other_means; k < first.size(); ++k) {
    const double shift = shifts(k - factors);
    above.push_back(first[k] + mean[k] + shift);
    below.push_back(first[k] + mean[k] - shift);
  }
  return (f(above) - f(below)) / 2;
}

}  // namespace

std::optional<FixedMeans> fixed_means(const EnsembleSettings& settings, const Scheme& scheme) {
  return scheme.bath_within() ? std::nullopt : fixed_means(settings);
}

std::optional<FixedMeans> fixed_means(const EnsembleSettings& settings) {
  if (settings.hybrid_monte_carlo) return std::nullopt;
  if (settings.constant_energy()) return FixedMeans::energy;
  if (!settings.thermostat || !std::holds_alternative<Rescaling>(*settings.thermostat))
    return std::nullopt;
  if (!settings.barostat) return FixedMeans::kinetic_energy;
  if (settings.barostat->edges != BarostatSettings{}.edges) return std::nullopt;
  return std::holds_alternative<VolumeMoves>(settings.barostat->type)
             ? FixedMeans::kinetic_energy_and_pressure_of_positions
             : FixedMeans::kinetic_energy_and_pressure;
}

StepError step_error(const Energies& now, FixedMeans fixed, double ideal) {
  StepError at{now.step_error, now.total(), now.kinetic(), now.pressure, now.volume};
  if (fixed == FixedMeans::energy) at.error = -now.total();
  if (fixed == FixedMeans::kinetic_energy_and_pressure_of_positions)
    at.pressure += (ideal - 2 * now.translation / 3) / now.volume;
  return at;
}

void StepResponse::add(const StepError& at, std::span<const double> quantities) {
  std::vector<double> x{at.error, at.total, at.volume, at.kinetic, at.pressure};
  x.insert(x.end(), quantities.begin(), quantities.end());
  if (first.empty()) first = x;
  for (std::size_t k = 0; k < x.size(); ++k) x[k] -= first[k];
  const std::size_t averages = x.size() - factors;
  x.resize(x.size() + factors * averages);
  for (std::size_t factor = 0; factor < factors; ++factor)
    for (std::size_t a = 0; a < averages; ++a)
      x[factors + averages + factor * averages + a] = x[factor] * x[factors + a];
  blocks.add(x);
}

std::size_t StepResponse::samples() const {
  return static_cast<std::size_t>(blocks.means().sum().weight);
}

SeriesEstimate StepResponse::bias(double degrees_of_freedom, FixedMeans fixed,
                                  const Function& f) const {
  return step_bias(std::span(this, 1), degrees_of_freedom, fixed, f);
}

StepResponse StepResponse::relative_to(const std::vector<double>& other) const {
  StepResponse moved = *this;
  moved.first = other;
  const std::size_t averages = first.size() - factors;
  std::vector<double> by(first.size());
  for (std::size_t k = 0; k < by.size(); ++k) by[k] = first[k] - other[k];
  for (BlockMeans::Block& block : moved.blocks.blocks) {
    for (std::size_t factor = 0; factor < factors; ++factor)
      for (std::size_t a = 0; a < averages; ++a)
        block.sum[factors + averages + factor * averages + a] +=
            by[factor] * block.sum[factors + a] + by[factors + a] * block.sum[factor] +
            block.weight * by[factor] * by[factors + a];
    for (std::size_t k = 0; k < by.size(); ++k) block.sum[k] += block.weight * by[k];
  }
  return moved;
}

SeriesEstimate step_bias(std::span<const StepResponse> runs, double degrees_of_freedom,
                         FixedMeans fixed, const StepResponse::Function& f) {
  if (runs.empty()) return {std::nan("")};
  std::vector<BlockMeans> means;
  for (const StepResponse& run : runs) means.push_back(run.blocks.means());
  const std::vector<double>& first = runs.front().first;
  return pooled_estimate(means, [&](std::span<const double> mean) {
    return bias_at(mean, first, Shifts(mean, first, degrees_of_freedom, fixed), f);
  });
}

}  // namespace polhode
