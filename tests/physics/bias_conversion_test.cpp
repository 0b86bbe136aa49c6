// SPDX-License-Identifier: MIT
// The bias of a step at constant temperature: converted from runs at constant energy, predicted by
// the runs themselves, and measured with a shorter step.
#include "run/adviser/bias_conversion.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "hot_water.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/math/fit.hpp"
#include "polhode/run/simulation/trajectory/trajectory.hpp"

using namespace polhode;

namespace {

constexpr unsigned seeds = 8;
constexpr double long_step = 0.004;  // [ps]: R of velocity Verlet is 3 %, of hoa2 0.2 %
constexpr double number_of_waters = 64;

const EnsembleSettings rescaled{.temperature = scenes::hot, .thermostat = Rescaling{0.2}};

System equilibrated(unsigned seed) {
  System system = scenes::hot_water(seed);
  ForceField forces(system.topology, system.forces, system.state.box);
  equilibrate(system, forces, 4);
  return system;
}

Trajectory trajectory(System system, unsigned seed, const char* scheme, double length,
                      const EnsembleSettings& ensemble) {
  ForceField forces(system.topology, system.forces, system.state.box);
  TrajectorySettings settings{.scheme = scheme_of(scheme),
                              .step = long_step,
                              .length = length,
                              .sample = 0.02,
                              .seed = seed,
                              .ensemble = ensemble};
  settings.shadow_sample = ensemble.constant_energy() ? 0 : settings.sample;
  const Trajectory t = run_trajectory(system, forces, settings);
  REQUIRE(t.failure == "");
  return t;
}

// Student's t of 7 degrees of freedom is beyond 5.4 by chance in 1 of 1000 cases. The next order of
// h² is a twentieth of the bias.
void check_equal(const Estimate& one, const Estimate& other) {
  CAPTURE(one.value);
  CAPTURE(one.error);
  CAPTURE(other.value);
  CAPTURE(other.error);
  CHECK(std::abs(one.value - other.value) <
        5.4 * std::hypot(one.error, other.error) + 0.05 * std::abs(other.value));
}

}  // namespace

TEST_CASE("biases at constant energy are converted to those at constant temperature") {
  std::vector<System> starts;
  for (unsigned k = 0; k < seeds; ++k) starts.push_back(equilibrated(k + 1));
  const IsochoricResponse response = isochoric_response(starts, scenes::hot, {long_step, 20});
  REQUIRE(response.energy.known == Known::yes);
  const BiasConversion conversion(starts.front(), rescaled, response);
  std::vector<double> unconverted, energy, energy_error, pressure, pressure_error, own_energy,
      own_pressure, long_steps, short_steps;
  for (unsigned k = 0; k < seeds; ++k) {
    Outcome run = outcome(starts[k], trajectory(starts[k], k, "velocity-verlet", 15, {}));
    unconverted.push_back(run.energy_bias);
    conversion.apply(run);
    energy.push_back(run.energy_bias), energy_error.push_back(run.energy_bias_error);
    pressure.push_back(run.pressure_bias), pressure_error.push_back(run.pressure_bias_error);
    const Trajectory warm = trajectory(starts[k], k, "velocity-verlet-ends", 30, rescaled);
    const StepBias own = warm.statistics.step_bias.bias(degrees_of_freedom(starts[k].topology),
                                                        FixedMeans::kinetic_energy, scenes::hot);
    own_energy.push_back(own.potential.value / number_of_waters);
    own_pressure.push_back(own.pressure.value);
    long_steps.push_back(warm.statistics.energies.potential() / number_of_waters);
    short_steps.push_back(
        trajectory(starts[k], k, "hoa2-ends", 30, rescaled).statistics.energies.potential() /
        number_of_waters);
  }
  const auto with_common = [](const std::vector<double>& values,
                              const std::vector<double>& common) {
    const Estimate m = mean(values);
    return Estimate{m.value, std::hypot(m.error, mean(common).value)};
  };
  const Estimate of_energy = with_common(energy, energy_error);
  const Estimate of_pressure = with_common(pressure, pressure_error);
  check_equal(of_energy, mean(own_energy));
  check_equal(of_pressure, mean(own_pressure));
  const Estimate longer = mean(long_steps), shorter = mean(short_steps);
  check_equal(of_energy, {longer.value - shorter.value, std::hypot(longer.error, shorter.error)});
  // Without conversion the bias of the energy is half as large, and that would be noticed.
  const Estimate at_constant_energy = mean(unconverted);
  CHECK(of_energy.value > 1.5 * at_constant_energy.value);
  CHECK(mean(own_energy).value - at_constant_energy.value >
        5.4 * std::hypot(mean(own_energy).error, at_constant_energy.error) +
            0.05 * mean(own_energy).value);
}
