// SPDX-License-Identifier: MIT
// The bias that the step gives to averages, as a run predicts it, against what the step does.
#include "polhode/measure/step_bias.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "hot_water.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/model/degrees_of_freedom.hpp"
#include "polhode/run/simulation/trajectory/trajectory.hpp"

using namespace polhode;

namespace {

constexpr std::size_t runs = 12;

Trajectory trajectory(unsigned seed, const char* scheme, const EnsembleSettings& ensemble) {
  System system = scenes::hot_water(seed, Precision::double_precision);
  ForceField forces(system.topology, system.forces, system.state.box);
  equilibrate(system, forces, 4);
  TrajectorySettings settings{
      .scheme = scheme_of(scheme), .step = 0.004, .length = 2, .seed = seed, .ensemble = ensemble};
  settings.sample = 0.02;
  run_trajectory(system, forces, settings);
  settings.length = 80;
  settings.configurational_sample = 0.1;
  settings.shadow_sample =
      settings.has_shadow() && !ensemble.constant_energy() ? settings.sample : 0;
  return run_trajectory(system, forces, settings);
}

// Mean and standard error of values of independent runs.
struct Mean {
  double value = 0, error = 0;
};
Mean mean_of(const std::array<double, runs>& x) {
  Mean m;
  for (const double value : x) m.value += value / runs;
  for (const double value : x) m.error += (value - m.value) * (value - m.value);
  m.error = std::sqrt(m.error / (runs - 1) / runs);
  return m;
}

// Student's t of 11 degrees of freedom is beyond 4.4 by chance in 1 of 1000 cases.
constexpr double likely = 4.4;

}  // namespace

// Without the error of the step both motions have one temperature: the difference that is seen is
// the time-step bias, and has to be as large as predicted from fluctuations, of which it is no
// part. R is 3 % here, and the next order of h² a twentieth of the bias.
TEST_CASE("step bias: water has the predicted difference of temperatures") {
  const EnsembleSettings rescaling{.temperature = scenes::hot, .thermostat = Rescaling{0.5}};
  for (const bool constant_energy : {true, false}) {
    CAPTURE(constant_energy);
    std::array<double, runs> predicted, unexplained, predicted_excess, unexplained_excess;
    for (unsigned run = 0; run < runs; ++run) {
      const Trajectory t = constant_energy
                               ? trajectory(run + 1, "velocity-verlet", {})
                               : trajectory(run + 101, "velocity-verlet-ends", rescaling);
      const DegreesOfFreedom n =
          degrees_of_freedom(scenes::hot_water(1, Precision::double_precision).topology);
      const Temperatures T = t.statistics.energies.temperatures(n);
      const FixedMeans fixed = constant_energy ? FixedMeans::energy : FixedMeans::kinetic_energy;
      predicted[run] = t.statistics.step_bias.bias(n, fixed).difference.value;
      unexplained[run] =
          (T.rotation[0] + T.rotation[1] + T.rotation[2]) / 3 - T.translation - predicted[run];
      const StepBias kinetic = t.statistics.step_bias.bias(n, fixed);
      const auto bias = t.statistics.configurational.step_bias(n.all(), fixed);
      const auto configurational = t.statistics.configurational.temperatures();
      predicted_excess[run] = unexplained_excess[run] = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const double excess = bias[1 + k].value().value - kinetic.axes[k].value;
        predicted_excess[run] += excess / 3;
        unexplained_excess[run] +=
            (configurational[1 + k].value().value - T.rotation[k] - excess) / 3;
      }
    }
    const Mean bias = mean_of(predicted), rest = mean_of(unexplained);
    CAPTURE(bias.value);
    CAPTURE(bias.error);
    CAPTURE(rest.value);
    CAPTURE(rest.error);
    CHECK(std::abs(bias.value) > 10 * bias.error);
    CHECK(std::abs(bias.value) > 1.5 * likely * rest.error);  // no prediction would be noticed
    CHECK(std::abs(rest.value) < likely * rest.error + 0.05 * std::abs(bias.value));
    // In positions rotation is hotter than in momenta: the configurational temperature, a ratio of
    // averages, minus the kinetic one.
    const Mean excess = mean_of(predicted_excess), other = mean_of(unexplained_excess);
    CAPTURE(excess.value);
    CAPTURE(excess.error);
    CAPTURE(other.value);
    CAPTURE(other.error);
    CHECK(excess.value > 10 * excess.error);
    CHECK(excess.value > 1.5 * likely * other.error);
    CHECK(std::abs(other.value) < likely * other.error + 0.05 * excess.value);
  }
}

// With the bath in the middle of the steps, momenta of full steps are colder by the mean of h²/4 of
// the squared forces over the masses, here by 2 %; those on which the bath acts have its
// temperature. The next order of h² is a hundredth.
TEST_CASE(
    "step bias: with the bath within the steps, the momenta of half steps have its temperature") {
  const EnsembleSettings langevin{.temperature = scenes::hot, .thermostat = Langevin{5, 5}};
  const DegreesOfFreedom n =
      degrees_of_freedom(scenes::hot_water(1, Precision::double_precision).topology);
  std::array<double, runs> full, half;
  for (unsigned run = 0; run < runs; ++run) {
    const Trajectory t = trajectory(run + 201, "baoab", langevin);
    full[run] = t.statistics.energies.temperatures(n).all;
    half[run] = t.statistics.at_bath.temperatures(n).all;
  }
  CHECK(std::abs(mean_of(half).value - scenes::hot) <
        likely * mean_of(half).error + 0.01 * scenes::hot);
  CHECK(mean_of(full).value < scenes::hot - 2 * likely * mean_of(full).error);
}
