// SPDX-License-Identifier: MIT
#include "polhode/measure/step_bias.hpp"

#include <algorithm>
#include <span>

namespace polhode {
namespace {

/// What is averaged, and the two other quantities of which sums are needed.
enum Quantity : std::size_t {
  translation,
  rotation_1,
  rotation_2,
  rotation_3,
  potential,
  pressure,
  volume,
  averages,
  error = averages,
  energy,
  quantities
};

using Values = std::array<double, quantities>;
/// A linear combination of averages.
using Weights = std::array<double, averages>;

/// Quantities whose products with all averages are summed.
constexpr std::array<Quantity, 3> factors{error, energy, volume};
constexpr Weights kinetic_energy{1, 1, 1, 1};
constexpr Weights pressure_alone{0, 0, 0, 0, 0, 1};

Values values(const Energies& e, double shadow_error) {
  return {e.translation, e.rotation[0], e.rotation[1], e.rotation[2], e.potential(),
          e.pressure,    e.volume,      shadow_error,  e.total()};
}

/// The bias of linear combinations of averages, from the means of the sums.
class Bias {
 public:
  Bias(std::span<const double> mean, double kinetic, double kT, FixedMeans fixed)
      : mean_(mean), kT_(kT) {
    if (fixed != FixedMeans::energy) warmer_ = covariance(0, kinetic_energy) / (kT * kinetic);
    if (fixed == FixedMeans::kinetic_energy_and_pressure)
      pressure_ = of_error(pressure_alone) + of_temperature(pressure_alone);
  }

  double operator()(const Weights& w) const {
    return of_error(w) + of_temperature(w) + of_volume(w);
  }

 private:
  /// Of the combination with a factor.
  double covariance(std::size_t factor, const Weights& w) const {
    const double* product = &mean_[quantities + factor * averages];
    double sum = 0;
    for (std::size_t a = 0; a < averages; ++a)
      sum += w[a] * (product[a] - mean_[factors[factor]] * mean_[a]);
    return sum;
  }
  double of_error(const Weights& w) const { return -covariance(0, w) / kT_; }
  double of_temperature(const Weights& w) const { return warmer_ * covariance(1, w) / kT_; }
  double of_volume(const Weights& w) const { return pressure_ * covariance(2, w) / kT_; }

  std::span<const double> mean_;
  double kT_;
  double warmer_ = 0;    // relative shift of the temperature, so that the kinetic energy has none
  double pressure_ = 0;  // bias of the pressure at constant volume, which the volume takes up
};

/// [K] for one [kJ/mol] of kinetic energy; 0 without degrees of freedom.
double kelvin(double degrees_of_freedom) { return temperature(1, degrees_of_freedom); }

}  // namespace

std::optional<FixedMeans> fixed_means(const EnsembleSettings& settings, const Scheme& scheme) {
  if (settings.hybrid_monte_carlo || scheme.bath_within()) return std::nullopt;
  if (settings.constant_energy()) return FixedMeans::energy;
  if (!settings.thermostat || settings.thermostat->kind != ThermostatKind::rescaling)
    return std::nullopt;
  return settings.barostat ? FixedMeans::kinetic_energy_and_pressure : FixedMeans::kinetic_energy;
}

void StepBiasStatistics::add(const Energies& now, double error_now) {
  if (samples++ == 0) first = now, first_error = error_now;
  Values x = values(now, error_now);
  const Values start = values(first, first_error);
  for (std::size_t k = 0; k < quantities; ++k) x[k] -= start[k];
  std::array<double, quantities + factors.size() * averages> sums{};
  std::copy(x.begin(), x.end(), sums.begin());
  for (std::size_t f = 0; f < factors.size(); ++f)
    for (std::size_t a = 0; a < averages; ++a)
      sums[quantities + f * averages + a] = x[factors[f]] * x[a];
  blocks.add(sums);
}

StepBias StepBiasStatistics::bias(const DegreesOfFreedom& n, FixedMeans fixed) const {
  const BlockMeans means = blocks.means();
  const auto of = [&](const Weights& weights) {
    return series_estimate(means, [&](std::span<const double> mean) {
      const double kinetic = first.kinetic() + mean[translation] + mean[rotation_1] +
                             mean[rotation_2] + mean[rotation_3];
      return Bias(mean, kinetic, 2 * kinetic / n.all(), fixed)(weights);
    });
  };
  const double t = kelvin(n.translation), r = kelvin(n.all() - n.translation);
  return {.translation = of({t}),
          .rotation = of({0, r, r, r}),
          .axes = {of({0, kelvin(n.rotation[0])}), of({0, 0, kelvin(n.rotation[1])}),
                   of({0, 0, 0, kelvin(n.rotation[2])})},
          .difference = of({-t, r, r, r}),
          .potential = of({0, 0, 0, 0, 1}),
          .pressure = of(pressure_alone),
          .volume = of({0, 0, 0, 0, 0, 0, 1})};
}

}  // namespace polhode
