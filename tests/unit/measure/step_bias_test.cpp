// SPDX-License-Identifier: MIT
// The bias of averages from samples of distributions whose shadow energy is known: compared with
// the exact bias, from both sides.
#include "polhode/measure/step_bias.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "polhode/base/units.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/math/random.hpp"

using namespace polhode;

namespace {

constexpr double kT = 2.5;                    // [kJ/mol]
constexpr int modes = 30;                     // of each kind of motion
constexpr double slow = 0.002, fast = 0.012;  // ω²h²/6 of translation, and of rotation
const DegreesOfFreedom degrees{modes, {modes, 0, 0}};

// Kinetic and potential energies of harmonic modes.
struct Modes {
  double kinetic[2]{}, potential[2]{};
  double total() const { return kinetic[0] + kinetic[1] + potential[0] + potential[1]; }
  // Of velocity Verlet: h² (V̈/12 − W/24), where V̈ = 2 ω² K and W = 2 ω² V.
  double error() const {
    return slow * (kinetic[0] - potential[0] / 2) + fast * (kinetic[1] - potential[1] / 2);
  }
};

// Independent modes with the distribution exp(−H̃/kT).
Modes canonical(Random& random) {
  Modes m;
  for (int kind = 0; kind < 2; ++kind) {
    const double a = kind == 0 ? slow : fast;
    for (int k = 0; k < modes; ++k) {
      const double p = random.normal(), q = random.normal();
      m.kinetic[kind] += kT / 2 * p * p / (1 + a);
      m.potential[kind] += kT / 2 * q * q / (1 - a / 2);
    }
  }
  return m;
}

Energies energies_of(const Modes& m, double scale = 1) {
  return {.coulomb = scale * (m.potential[0] + m.potential[1]),
          .translation = scale * m.kinetic[0],
          .rotation = {scale * m.kinetic[1], 0, 0},
          .volume = 1};
}

StepError error_of(double error, const Energies& e) {
  return {error, e.total(), e.kinetic(), e.pressure, e.volume};
}

void check(const SeriesEstimate& found, double expected) {
  CAPTURE(found.value);
  CAPTURE(found.error);
  CAPTURE(expected);
  CHECK(found.known == Known::yes);
  CHECK(found.error < 0.25 * std::abs(expected));
  // 4.5 standard errors, estimated from 20 to 39 blocks; then the next order, and the difference of
  // constant energy and constant temperature, 4 of the number of degrees of freedom of K and V.
  CHECK(std::abs(found.value - expected) <
        4.5 * found.error + (2 * fast + 4.0 / (4 * modes)) * std::abs(expected));
}

// Of one degree of freedom that has one kJ/mol more.
double kelvin(double kinetic) { return 2 * kinetic / (modes * units::boltzmann); }

constexpr int samples = 40'000;
constexpr double average = (slow + fast) / 2, energy = modes * kT / 2;

}  // namespace

TEST_CASE("step bias: harmonic modes at constant energy") {
  StepBiasStatistics statistics;
  Random random(11);
  const double shadow = 4 * energy;
  for (int n = 0; n < samples; ++n) {
    const Modes m = canonical(random);
    const double scale = shadow / (m.total() + m.error());  // onto the surface of constant H̃
    statistics.add(error_of(-scale * m.total(), energies_of(m, scale)), energies_of(m, scale));
  }
  const StepBias bias = statistics.bias(degrees, FixedMeans::energy);
  // Relative changes: −a of K and a/2 of V at one temperature, which is a quarter of the mean a
  // higher, so that the energy is the same.
  check(bias.potential, energy * (2 * average / 4 + (slow + fast) / 2));
  check(bias.translation, kelvin(energy * (average / 4 - slow)));
  check(bias.rotation, kelvin(energy * (average / 4 - fast)));
  check(bias.axes[0], bias.rotation.value);
  check(bias.difference, kelvin(energy * (slow - fast)));
  CHECK(bias.axes[1].value == 0);
}

TEST_CASE("step bias: harmonic modes with a rescaling thermostat") {
  StepBiasStatistics statistics;
  Random random(12);
  for (int n = 0; n < samples; ++n) {
    const Modes m = canonical(random);
    statistics.add(error_of(m.error(), energies_of(m)), energies_of(m));
  }
  const StepBias bias = statistics.bias(degrees, FixedMeans::kinetic_energy);
  // The temperature is higher by the mean a, so that the kinetic energy is the same.
  check(bias.potential, energy * (2 * average + (slow + fast) / 2));
  check(bias.translation, kelvin(energy * (average - slow)));
  check(bias.rotation, kelvin(energy * (average - fast)));
  check(bias.difference, kelvin(energy * (slow - fast)));
}

// H = K + κ (𝒱 − 𝒱₀)²/2, and a part y of the pressure, on which the error depends.
TEST_CASE("step bias: the volume takes up the bias of the pressure") {
  StepBiasStatistics statistics;
  Random random(13);
  constexpr double stiffness = 50, spread = 3, error = 0.02;
  for (int n = 0; n < samples; ++n) {
    const double y = spread * random.normal(), v = std::sqrt(kT / stiffness) * random.normal();
    double kinetic = 0;
    for (int k = 0; k < modes; ++k) kinetic += kT / 2 * std::pow(random.normal(), 2);
    const Energies now{.coulomb = stiffness * v * v / 2,
                       .translation = kinetic,
                       .rotation = {},
                       .pressure = -stiffness * v + y,
                       .volume = 10 + v};
    statistics.add(error_of(error * y, now), now);
  }
  const DegreesOfFreedom translation{modes, {}};
  const double pressure = -error * spread * spread / kT;
  check(statistics.bias(translation, FixedMeans::kinetic_energy).pressure, pressure);
  constexpr double mass = 18, V = 10;
  const StepBias bias =
      statistics.bias(translation, FixedMeans::kinetic_energy_and_pressure, 300, mass);
  check(bias.volume, pressure / stiffness);
  // The mean of M/V, of volumes with the variance kT/κ.
  check(bias.density, -mass * pressure / stiffness / (V * V) * (1 + 3 * kT / stiffness / (V * V)));
}

// An error fast K_rot: at one mean of the kinetic energy, translation is warmer by half of it.
// 𝒱 has the density whose logarithm has the derivative (P' − P₀)/kT, where P' = −κ (𝒱 − 𝒱₀) + P₀ is
// what Monte Carlo moves hold; P has the actual kinetic energy of translation in place of N kT.
TEST_CASE("step bias: Monte Carlo moves hold the pressure without the kinetic energy") {
  StepBiasStatistics moves, rescaling;
  Random random(14);
  constexpr double stiffness = 50, volume = 10, bodies = modes / 3.0, warmer = fast / 2;
  for (int n = 0; n < samples; ++n) {
    const double v = std::sqrt(kT / stiffness) * random.normal();
    double translation = 0, rotation = 0;
    for (int k = 0; k < modes; ++k) {
      translation += kT / 2 * (1 + warmer) * std::pow(random.normal(), 2);
      rotation += kT / 2 * (1 + warmer) / (1 + fast) * std::pow(random.normal(), 2);
    }
    Energies now{.coulomb = stiffness * v * v / 2,
                 .translation = translation,
                 .rotation = {rotation, 0, 0},
                 .volume = volume + v};
    now.pressure = -stiffness * v + (2 * translation / 3 - bodies * kT) / now.volume;
    now.step_error = fast * rotation;
    moves.add(step_error(now, FixedMeans::kinetic_energy_and_pressure_of_positions, bodies * kT),
              now);
    rescaling.add(step_error(now, FixedMeans::kinetic_energy_and_pressure, bodies * kT), now);
  }
  const double pressure = bodies * kT * warmer / volume;
  const StepBias held = moves.bias(degrees, FixedMeans::kinetic_energy_and_pressure_of_positions);
  check(held.pressure, pressure);
  CHECK(std::abs(held.volume.value) < 4.5 * held.volume.error);
  CHECK(held.volume.error < 0.25 * pressure / stiffness);
  // Cell rescaling would let the volume take it up.
  const StepBias scaled = rescaling.bias(degrees, FixedMeans::kinetic_energy_and_pressure);
  check(scaled.volume, pressure / stiffness);
  CHECK(std::abs(scaled.pressure.value) < 4.5 * scaled.pressure.error + 0.05 * pressure);
}

TEST_CASE("schemes whose last kick follows a bath") {
  CHECK(scheme_of("baoab").kick_after_bath() == 0.5);
  CHECK(scheme_of("B(1/3) A(1/2) B(1/6) O(1) B(1/6) A(1/2) B(1/3)").kick_after_bath() == 0);
  for (const char* name : {"obabo", "hoa2-ends", "hoa2", "velocity-verlet", "position-verlet"})
    CHECK(scheme_of(name).kick_after_bath() == 0);
  CHECK(scheme_of("baoab").bath_within());
  CHECK_FALSE(scheme_of("obabo").bath_within());
}

TEST_CASE("step bias: where the distribution is that of a shadow energy") {
  const Scheme hoa2 = scheme_of("hoa2");
  CHECK(fixed_means({}, hoa2) == FixedMeans::energy);
  EnsembleSettings settings{.temperature = 300, .thermostat = ThermostatSettings{}};
  CHECK(fixed_means(settings, scheme_of("hoa2-ends")) == std::nullopt);
  settings.thermostat = Rescaling{};
  CHECK(fixed_means(settings, scheme_of("hoa2-ends")) == FixedMeans::kinetic_energy);
  CHECK(fixed_means(settings, scheme_of("baoab")) == std::nullopt);
  settings.barostat = BarostatSettings{};
  CHECK(fixed_means(settings, scheme_of("obabo")) == FixedMeans::kinetic_energy_and_pressure);
  settings.barostat->type = VolumeMoves{};
  CHECK(fixed_means(settings, scheme_of("obabo")) ==
        FixedMeans::kinetic_energy_and_pressure_of_positions);
  settings.barostat->edges = {{true, true, false}, {false, false, true}};
  CHECK(fixed_means(settings, scheme_of("obabo")) == std::nullopt);
  settings.barostat.reset();
  settings.thermostat = SeparateRescaling{};
  CHECK(fixed_means(settings, scheme_of("obabo")) == std::nullopt);
  CHECK(fixed_means({.temperature = 300, .hybrid_monte_carlo = HybridMonteCarloSettings{}}, hoa2) ==
        std::nullopt);
}
