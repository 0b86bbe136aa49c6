// SPDX-License-Identifier: MIT
#include "polhode/measure/step_bias.hpp"

#include <algorithm>
#include <cmath>

#include "polhode/base/units.hpp"

namespace polhode {
namespace {

enum Averaged : std::size_t {
  translation,
  rotation_1,
  rotation_2,
  rotation_3,
  potential,
  pressure,
  volume,
  volume_square
};

/// The temperature per kinetic energy [K mol/kJ]; 0 without degrees of freedom.
double kelvin(double degrees_of_freedom) { return polhode::temperature(1, degrees_of_freedom); }

/// The mean ⟨1/V⟩ to second order in the fluctuations, which are 2 % in a liquid of a hundred
/// molecules.
double mean_inverse_volume(std::span<const double> mean) {
  const double V = mean[volume];
  if (!(V > 0)) return 0;
  return (1 + (mean[volume_square] - V * V) / (V * V)) / V;
}

}  // namespace

void StepBiasStatistics::add(const StepError& at, const Energies& now) {
  response.add(at, std::array{now.translation, now.rotation[0], now.rotation[1], now.rotation[2],
                              now.potential(), now.pressure, now.volume, now.volume * now.volume});
}

StepBias StepBiasStatistics::bias(const DegreesOfFreedom& n, FixedMeans fixed, double temperature,
                                  double mass) const {
  using Means = std::span<const double>;
  const auto of = [&](const StepResponse::Function& f) { return response.bias(n.all(), fixed, f); };
  const auto average = [&](Averaged which, double scale) {
    return of([=](Means mean) { return scale * mean[which]; });
  };
  const double t = kelvin(n.translation), r = kelvin(n.all() - n.translation);
  const double kT = units::boltzmann * temperature;
  const auto rotation = [r](Means mean) {
    return r * (mean[rotation_1] + mean[rotation_2] + mean[rotation_3]);
  };
  return {.translation = average(translation, t),
          .rotation = of(rotation),
          .axes = {average(rotation_1, kelvin(n.rotation[0])),
                   average(rotation_2, kelvin(n.rotation[1])),
                   average(rotation_3, kelvin(n.rotation[2]))},
          .difference = of([=](Means mean) { return rotation(mean) - t * mean[translation]; }),
          .potential = average(potential, 1),
          .pressure = average(pressure, 1),
          .volume = average(volume, 1),
          .density = of([=](Means mean) { return mass * mean_inverse_volume(mean); }),
          .compressibility = of([kT](Means mean) {
            const double variance = mean[volume_square] - mean[volume] * mean[volume];
            return kT > 0 ? variance / (kT * mean[volume]) : 0;
          })};
}

SeriesEstimate without_bias(const SeriesEstimate& average, const SeriesEstimate& bias) {
  SeriesEstimate corrected = average;
  corrected.value -= bias.value;
  if (average.known == Known::yes && bias.known == Known::yes) {
    corrected.error = std::hypot(average.error, bias.error);
    if (bias.error > 0) corrected.modes = std::min(average.modes, bias.modes);
  } else {
    if (average.known == Known::yes) corrected.known = bias.known;
    corrected.error = corrected.modes = 0;
  }
  return corrected;
}

}  // namespace polhode
