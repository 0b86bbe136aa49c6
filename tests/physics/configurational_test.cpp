// SPDX-License-Identifier: MIT
// Configurational temperatures: curvatures from differences of the energy, and the temperature of
// an exactly sampled ensemble.
#include "polhode/measure/configurational_temperature.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <vector>

#include "polhode/base/units.hpp"
#include "polhode/integrate/flows.hpp"
#include "polhode/integrate/integrator.hpp"
#include "polhode/integrate/rodrigues.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/math/fit.hpp"
#include "polhode/measure/energy.hpp"
#include "scenes.hpp"

using namespace polhode;

namespace {

/// tr M⁻¹∇∇V of each motion, by second differences of the energy along every degree of freedom.
ByMotion<double> curvature_of_energy(const scenes::Scene& scene, ForceField& forces) {
  const auto potential = [&](const State& state) {
    Load load;
    forces(state, load);
    return load.potential();
  };
  // Second differences with e = 1e-4 nm, or rad/10: the fourth derivative contributes (e/0.03 nm)²,
  // 1e-5 of the second; rounding, 1e-13 kJ/mol over e², is 1e-5 of curvatures of 10³ kJ/mol/nm² or
  // more.
  const auto along = [&](std::size_t i, const Vec3<double>& dq, const Vec3<double>& dtheta) {
    const auto moved = [&](double sign) {
      State state = scene.state;
      state.q.set(i, state.q[i] + sign * dq);
      state.orientation.set(i, state.orientation[i] * rodrigues(sign * dtheta));
      return potential(state);
    };
    const double e2 = norm2(dq) + norm2(dtheta);
    return (moved(1) - 2 * potential(scene.state) + moved(-1)) / e2;
  };
  ByMotion<double> sum{};
  for (std::size_t i = 0; i < scene.state.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      Vec3<double> unit{};
      unit[k] = 1;
      sum[0] += scene.bodies.inverse_m[i] * along(i, 1e-4 * unit, {});
      sum[1 + k] += scene.bodies.inverse_J[i][k] * along(i, {}, 1e-3 * unit);
    }
  return sum;
}

}  // namespace

// The mean over random signs is Gaussian with an error known from the samples: five standard errors
// are exceeded once in 2 million. The estimate for each motion must be precise enough to
// distinguish it from the others, and from one with a wrong sign.
TEST_CASE("the curvature of each motion is the second derivative of V along it") {
  for (const scenes::Scene& scene :
       {scenes::water_cluster(),
        scenes::lattice({{"tip4p", 2}, {"n2", 2}, {"argon", 1}}, 0.42, 40, 5)}) {
    ForceField forces(scene.topology, scenes::no_truncation(), scene.state.box);
    Load load;
    forces(scene.state, load);
    const ByMotion<double> exact = curvature_of_energy(scene, forces);
    constexpr std::uint64_t samples = 20000;
    std::array<std::vector<double>, std::tuple_size_v<ByMotion<double>>> drawn;
    for (std::uint64_t n = 0; n < samples; ++n) {
      const ConfigurationalSample sample =
          configurational_sample(scene.state, scene.bodies, load, forces, Random(3, n));
      for (std::size_t k = 0; k < drawn.size(); ++k) drawn[k].push_back(sample.curvature[k]);
    }
    for (std::size_t k = 0; k < drawn.size(); ++k) {
      CAPTURE(k);
      const Estimate estimate = mean(drawn[k]);
      CHECK(std::abs(estimate.value - exact[k]) < 5 * estimate.error + 1e-4 * std::abs(exact[k]));
      CHECK(estimate.error < 0.1 * std::abs(exact[k]));
      for (std::size_t other = 0; other < k; ++other)
        CHECK(std::abs(exact[k] - exact[other]) > 10 * estimate.error);
    }
  }
}

namespace {

/// Hybrid Monte Carlo: states of the canonical ensemble at T, each from a trajectory with new
/// momenta, accepted with the Metropolis probability, so that the ensemble is exact for any step.
template <class Each>
double sampled(scenes::Scene& scene, ForceField& forces, double T, int states, const Each& each) {
  const double kT = units::boltzmann * T;
  std::mt19937_64 random(17);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  const auto vector = [&] {
    const double x = normal(random), y = normal(random), z = normal(random);
    return Vec3<double>{x, y, z};
  };
  const auto root = [](const Vec3<double>& v) {
    return Vec3<double>{std::sqrt(v.x), std::sqrt(v.y), std::sqrt(v.z)};
  };
  Integrator integrator(scheme_of("hoa2"), scene.bodies, forces);
  State& state = scene.state;
  const auto energy = [&] { return energies(state, scene.bodies, integrator.load(state)).total(); };
  int taken = 0;
  for (int n = -states / 10; n < states; ++n) {
    for (std::size_t i = 0; i < state.size(); ++i) {
      state.p.set(i, std::sqrt(kT * scene.bodies.m[i]) * vector());
      const Vec3<double> L = std::sqrt(kT) * scaled(root(scene.bodies.J[i]), vector());
      state.ell.set(i, to_lab(state.orientation[i], L));
    }
    const State before = state;
    const double start = energy();
    integrator.advance(state, 0.005, 8);
    if (uniform(random) < std::exp((start - energy()) / kT)) {
      ++taken;
    } else {
      state = before;
      integrator.forget();
    }
    if (n >= 0) each(integrator.load(state));
  }
  return taken / (1.1 * states);
}

}  // namespace

// 18 waters, 6 nitrogens and 3 argons at 400 K, dense enough that all interact. Five standard
// errors of the ratio; with less than 2 % of T each, wrong factors or exchanged motions would be
// detected.
TEST_CASE("in the canonical ensemble every configurational temperature equals the temperature") {
  constexpr double T = 400;
  scenes::Scene scene = scenes::lattice({{"tip4p", 18}, {"n2", 6}, {"argon", 3}}, 0.42, 1.3, 9);
  ForceField forces(scene.topology, {.cutoff = 0.5, .switch_from = 0.35, .skin = 0.02},
                    scene.state.box);
  ConfigurationalStatistics samples;
  std::uint64_t stream = 0;
  const double taken = sampled(scene, forces, T, 8000, [&](const Load& load) {
    samples.add(
        configurational_sample(scene.state, scene.bodies, load, forces, Random(5, stream++)));
  });
  CHECK(taken > 0.5);
  CHECK(taken < 0.999);  // otherwise the accepted energies would not be those of this ensemble
  const auto temperatures = samples.temperatures();
  for (std::size_t k = 0; k < temperatures.size(); ++k) {
    CAPTURE(k);
    REQUIRE(temperatures[k]);
    REQUIRE(temperatures[k]->known == Known::yes);
    CHECK(std::abs(temperatures[k]->value - T) < 5 * temperatures[k]->error);
    CHECK(temperatures[k]->error < 0.02 * T);
  }
}

TEST_CASE("a motion without forces or inertia has no configurational temperature") {
  const scenes::Scene argon = scenes::lattice({{"argon", 2}}, 0.36, 40, 1);
  ForceField forces(argon.topology, scenes::no_truncation(), argon.state.box);
  Load load;
  forces(argon.state, load);
  const ConfigurationalSample sample =
      configurational_sample(argon.state, argon.bodies, load, forces, Random(1));
  ConfigurationalStatistics one;
  one.add(sample);
  const auto temperatures = one.temperatures();
  REQUIRE(temperatures[0]);
  CHECK(temperatures[0]->value ==
        sample.squared_force[0] / (units::boltzmann * sample.curvature[0]));
  CHECK(temperatures[0]->known == Known::too_few_samples);
  for (std::size_t k = 1; k < temperatures.size(); ++k) CHECK(!temperatures[k]);
  for (const auto& none : ConfigurationalStatistics{}.temperatures()) CHECK(!none);
}
