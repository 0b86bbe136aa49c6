// SPDX-License-Identifier: MIT
#include "polhode/run/simulation/report/rounding.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "polhode/integrate/scheme_text.hpp"
#include "polhode/math/random.hpp"
#include "polhode/run/simulation/trajectory/trajectory.hpp"
#include "rms.hpp"
#include "run/study/guideline.hpp"

using namespace polhode;

namespace {

System water(Precision precision) {
  Config config = default_config();
  config.forces.precision = precision;
  return build_system(config);
}

}  // namespace

TEST_CASE("weights of kicks: shared evaluations add, finite differences divide by lambda") {
  constexpr double eta = 0.1931833275037836;
  const auto close = [](double x) { return doctest::Approx(x).epsilon(1e-12); };
  CHECK(kick_weights(scheme_of("velocity-verlet"), 1e-4) == close(1));
  CHECK(kick_weights(scheme_of("A(1/2) B(1) A(1/2)"), 1e-4) == close(1));
  CHECK(kick_weights(scheme_of("hoa2"), 1) == close(4 * eta * eta + (1 - 2 * eta) * (1 - 2 * eta)));
  CHECK(kick_weights(scheme_of("gier4"), 1) == close(5.0 / 9));
  CHECK(kick_weights(scheme_of("O(1/2) B(1/2) A(1) B(1/4) O(1/2) B(1/4)"), 1e-4) == close(1));
  // 1/9 and 4/9 [(1 − 1/λ)² + 1/λ²] with λ = 1/10
  CHECK(kick_weights(scheme_of("gier4-fd"), 0.1) == close((1 + 4 * 181) / 9.0));
}

TEST_CASE("rounding makes a random walk that grows with h and t, on top of a floor") {
  const Scheme scheme = scheme_of("velocity-verlet");
  CHECK(rounding_fluctuation({3, 0}, scheme, 1, 0.002, 3) ==
        doctest::Approx(3 * std::sqrt(0.001)).epsilon(1e-12));
  CHECK(rounding_fluctuation({3, 0.7}, scheme, 1, 0.002, 0) == doctest::Approx(0.7));
}

TEST_CASE("a random walk deviates from its mean by a sixth of its final variance") {
  constexpr int walks = 4000, steps = 200;
  Random random(7);
  double variance = 0;
  for (int w = 0; w < walks; ++w) {
    std::vector<double> totals{0};
    for (int k = 0; k < steps; ++k) totals.push_back(totals.back() + random.normal());
    variance += std::pow(fluctuation(totals), 2) / walks;
  }
  // Velocity Verlet with power 1 and steps of 1: t = 200. The variance of a walk about its mean
  // scatters by 2/√5 of itself, so that of 4000 by 1.4 %; 4 times that.
  const double expected =
      std::pow(rounding_fluctuation({1, 0}, scheme_of("velocity-verlet"), 1, 1, steps), 2);
  CHECK(variance == doctest::Approx(expected).epsilon(0.06));
}

TEST_CASE("in double precision there is no noise") {
  const ForceNoise noise = force_noise(water(Precision::double_precision));
  CHECK(noise.power == 0);
  CHECK(noise.energy == 0);
}

// The same initial configuration in both precisions: the truncation error is the same until the
// trajectories diverge, so the difference of the total energies is due to rounding. The potential
// energy is evaluated twice along the mixed run: in float, where its noise dominates, and in
// double, where only the walk of the trajectory remains.
TEST_CASE("the random walk of the total energy follows from the noise of the forces") {
  const Scheme scheme = scheme_of("velocity-verlet");
  constexpr double step = 0.0005, length = 0.1;  // [ps]: 200 steps, before the trajectories diverge
  System mixed = water(Precision::mixed);
  const ForceNoise noise = force_noise(mixed);
  System full = water(Precision::double_precision);
  const TrajectorySettings settings{scheme, step, length, step, 1};
  ForceField forces(full.topology, full.forces, full.state.box);
  std::vector<double> truth;  // total energies
  run_trajectory(full, forces, settings,
                 {.sample = [&](std::size_t, const State&, const Energies& e) {
                   truth.push_back(e.total());
                 }});

  ForceField rounded(mixed.topology, mixed.forces, mixed.state.box);
  Load load(mixed.bodies.size());
  std::vector<double> walk, reading;  // differences from the run in double, by step
  run_trajectory(mixed, rounded, settings,
                 {[&](std::size_t k, const State& state, const Energies& e) {
                    forces(state, load);
                    walk.push_back(e.kinetic() + load.potential() - truth.at(k));
                    reading.push_back(e.potential() - load.potential());
                  },
                  nullptr});
  REQUIRE(walk.size() == 201);

  // 201 samples and sixteen states determine the deviation to 5 and 18 %: a factor 2 is four
  // deviations.
  const double read = fluctuation(reading);
  CHECK(read < 2 * noise.energy);
  CHECK(read > noise.energy / 2);

  // The states are between two half kicks of an evaluation, so k steps include k − 1 whole kicks
  // and two of half the weight: power² h² (k − 1/2). n increments determine the deviation to
  // 1/√(2n), and four times that is allowed either way; the power itself comes from 46080
  // differences.
  for (const std::size_t lag : {1u, 2u, 8u}) {
    double variance = 0, n = 0;
    for (std::size_t i = 0; i + lag < walk.size(); i += lag, ++n)
      variance += std::pow(walk[i + lag] - walk[i], 2);
    const double measured = std::sqrt(variance / n);
    const double expected = noise.power * step * std::sqrt(static_cast<double>(lag) - 0.5);
    const double margin = 1 + 4 / std::sqrt(2 * n);
    INFO("lag " << lag << ": measured " << measured << ", expected " << expected);
    CHECK(measured < margin * expected);
    CHECK(measured > expected / margin);
  }
}

TEST_CASE("a point below twice the R of rounding is dominated by rounding") {
  EfficiencyPoint p;
  p.ratio = {1.9e-5, 1e-7};
  p.rounding = 1e-5;
  CHECK(p.at_rounding());
  p.ratio.value = 2.1e-5;
  CHECK(!p.at_rounding());
  p.rounding = 0;  // double
  CHECK(!p.at_rounding());
}

TEST_CASE("no cost is extrapolated where rounding dominates") {
  EfficiencyPoint p;
  p.scheme = "gier4";
  p.order = 4;
  p.step = 0.002;
  p.cost = 1500;
  p.ratio = {3e-5, 1e-6};
  const auto extrapolated = [&] { return cost_at(curves({p})[0], 2e-5).has_value(); };
  CHECK(extrapolated());
  p.rounding = 2.9e-5;
  CHECK(!extrapolated());
}
