// SPDX-License-Identifier: MIT
// Exact laws of thermostats: variances, decay, and the distribution of kinetic energies.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <functional>
#include <string>

#include "base/instruction_set.hpp"
#include "ensemble/thermostat.hpp"
#include "ensemble/velocity_rescaling.hpp"
#include "polhode/base/units.hpp"
#include "polhode/ensemble/random_streams.hpp"
#include "polhode/integrate/integrator.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/measure/energy.hpp"
#include "scenes.hpp"

using namespace polhode;

namespace {

using scenes::kelvin;
using scenes::kT;

// A deviation in standard errors that occurs by chance in 6 of 100,000 checks.
constexpr double max_deviation = 4;

// Free bodies: an asymmetric, a symmetric and a linear top, and atoms.
scenes::Scene tops(std::size_t each) {
  return scenes::lattice({{"tip4p", each}, {"benzene", each}, {"co2", each}, {"argon", each}}, 1,
                         100, 1);
}

// The standard normal deviates that a flow has added to one body, from momenta 0: three of
// translation and one for each axis with inertia.
template <class F>
void each_deviate(const scenes::Scene& scene, const State& state, double width, const F& f) {
  for (std::size_t i = 0; i < state.size(); ++i) {
    const Vec3<double> L = to_body(state.orientation[i], state.ell[i]), J = scene.bodies.J[i];
    for (std::size_t k = 0; k < 3; ++k) {
      f(3 * scene.bodies.part[i], state.p[i][k] / std::sqrt(scene.bodies.m[i]) / width);
      if (J[k] > 0) f(3 * scene.bodies.part[i] + 1, L[k] / std::sqrt(J[k]) / width);
      if (J[k] == 0) CHECK(std::abs(L[k]) < 1e-15);
    }
  }
}

void stop(State& state) {
  state.p = Vec3Column(state.size());
  state.ell = Vec3Column(state.size());
}

LangevinSettings langevin(TotalMomentum total_momentum) {
  return {.kT = kT,
          .friction = 2,
          .rotational_friction = 5,
          .seed = 7,
          .total_momentum = total_momentum};
}

}  // namespace

// n deviates have a sum of squares with mean n and variance 2 n, a sum of cubes with mean 0 and
// variance 15 n, and a sum of fourth powers with mean 3 n and variance 96 n.
TEST_CASE(
    "the flow O adds normal deviates of variance (1 - c²) m kT and (1 - c²) J kT, every top") {
  scenes::Scene scene = tops(3000);
  stop(scene.state);
  constexpr double t = 0.3;
  ornstein_uhlenbeck(scene.state, scene.bodies, langevin(TotalMomentum::free), t, 1);
  struct Sums {
    double n = 0, squares = 0, cubes = 0, fourths = 0;
  };
  std::vector<Sums> sums(12);
  const double width[] = {std::sqrt((1 - std::exp(-2 * 2 * t)) * kT),
                          std::sqrt((1 - std::exp(-2 * 5 * t)) * kT)};
  each_deviate(scene, scene.state, 1, [&](std::size_t kind, double x) {
    Sums& s = sums[kind];
    x /= width[kind % 3];
    ++s.n, s.squares += x * x, s.cubes += x * x * x, s.fourths += x * x * x * x;
  });
  for (std::size_t kind = 0; kind < 11; ++kind) {
    const auto& [n, squares, cubes, fourths] = sums[kind];
    if (n == 0) continue;
    CAPTURE(kind);
    CHECK(std::abs(squares - n) < max_deviation * std::sqrt(2 * n));
    CHECK(std::abs(cubes) < max_deviation * std::sqrt(15 * n));
    CHECK(std::abs(fourths - 3 * n) < max_deviation * std::sqrt(96 * n));
  }
  CHECK(sums[1].n == 9000);  // tip4p
  CHECK(sums[7].n == 6000);  // co2: two axes
  CHECK(sums[10].n == 0);    // argon: none
}

// The part of the old momentum that is left is c, to the rounding of orientations.
TEST_CASE("the flow O lets momenta decay as exp(-γt), translation and rotation each with its own") {
  const scenes::Scene scene = tops(50);
  constexpr double t = 0.3;
  State moving = scene.state, still = scene.state;
  stop(still);
  for (State* state : {&moving, &still})
    ornstein_uhlenbeck(*state, scene.bodies, langevin(TotalMomentum::free), t, 1);
  for (std::size_t i = 0; i < moving.size(); ++i) {
    const Vec3<double> p = std::exp(-2 * t) * scene.state.p[i] + still.p[i];
    const Vec3<double> ell = std::exp(-5 * t) * scene.state.ell[i] + still.ell[i];
    CHECK(norm(moving.p[i] - p) < 1e-14 * (1 + norm(p)));
    CHECK(norm(moving.ell[i] - ell) < 1e-14 * (1 + norm(ell)));
  }
}

TEST_CASE("two flows O of half the time have the statistics of one, and noise of their own") {
  scenes::Scene scene = tops(3000);
  stop(scene.state);
  const LangevinSettings settings = langevin(TotalMomentum::free);
  State first = scene.state, second = scene.state, both = scene.state;
  ornstein_uhlenbeck(first, scene.bodies, settings, 0.1, stream_of(RandomUse::langevin, {5, 0}));
  ornstein_uhlenbeck(second, scene.bodies, settings, 0.1, stream_of(RandomUse::langevin, {5, 4}));
  ornstein_uhlenbeck(both, scene.bodies, settings, 0.1, stream_of(RandomUse::langevin, {5, 0}));
  ornstein_uhlenbeck(both, scene.bodies, settings, 0.1, stream_of(RandomUse::langevin, {5, 4}));
  double product = 0, squares = 0, n = 0;
  for (std::size_t i = 0; i < first.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const double m = scene.bodies.m[i], unit = m * kT * (1 - std::exp(-0.4));
      product += first.p[i][k] * second.p[i][k] / unit;
      squares += both.p[i][k] * both.p[i][k] / (m * kT * (1 - std::exp(-0.8)));
      ++n;
    }
  CHECK(std::abs(product) < max_deviation * std::sqrt(n));  // the variance of a product is 1
  CHECK(std::abs(squares - n) < max_deviation * std::sqrt(2 * n));
}

TEST_CASE("the bath of a thermostat has other random numbers for each seed, step and stage") {
  const scenes::Scene scene = tops(20);
  for (const ThermostatSettings& type :
       {ThermostatSettings(Langevin{}), ThermostatSettings(Rescaling{}),
        ThermostatSettings(SeparateRescaling{})}) {
    CAPTURE(type.index());
    const auto drawn = [&](std::uint64_t seed, StageNumber at) {
      State state = scene.state;
      Thermostat(type, kelvin, scene.topology, scene.bodies, seed)(state, 0.1, at);
      return std::array{state.p[7].x, state.ell[7].x};  // by the rescaling apart, each its own
    };
    const std::vector all = {drawn(3, {0, 0}), drawn(3, {0, 4}),
                             drawn(3, {1, 0}), drawn(3, {1ull << 33, 0}),
                             drawn(4, {0, 0}), drawn(5ull << 33, {0, 0})};
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        for (std::size_t c = 0; c < 2; ++c) CHECK(all[i][c] != all[k][c]);
    CHECK(drawn(3, {1, 0}) == all[2]);
  }
}

// Where both have the same kinetic energy and degrees of freedom, the same random numbers would
// give the same factor.
TEST_CASE("rescaling apart has other random numbers for rotation than for translation") {
  const scenes::Scene scene = scenes::lattice({{"tip4p", 20}}, 1, 100, 1);
  State state = scene.state;
  const Energies e = energies(state, scene.bodies, Load{});
  const double K = e.translation + energy_of_centre(state, scene.bodies, TotalMomentum::free);
  const double scale = std::sqrt(K / (e.kinetic() - e.translation));
  for (std::size_t i = 0; i < state.size(); ++i) state.ell.set(i, scale * state.ell[i]);
  const State before = state;
  Thermostat(SeparateRescaling{0.1}, kelvin, scene.topology, scene.bodies, 3, Workers::serial(),
             TotalMomentum::free)(state, 0.1, {0, 0});
  const double translation = state.p[0].x / before.p[0].x,
               rotation = state.ell[0].x / before.ell[0].x;
  CHECK(std::abs(translation - rotation) > 1e-6);
}

// 3 (N − 1) degrees of freedom: the mean of the sum of squares; its variance is twice that.
TEST_CASE(
    "with the total momentum held, O leaves it at 0 and translation 3 N - 3 degrees of freedom") {
  const scenes::Scene scene = scenes::lattice({{"tip4p", 5}, {"argon", 3}}, 1, 100, 1);
  LangevinSettings settings = langevin(TotalMomentum::held);
  double sum = 0;
  constexpr int draws = 4000;
  for (std::uint64_t n = 0; n < draws; ++n) {
    State state = scene.state;
    refresh_momenta(state, scene.bodies, settings, 0, n);
    CHECK(norm(total_momentum(state)) < 1e-12);
    sum += energies(state, scene.bodies, Load{}).translation * 2 / kT;
  }
  CHECK(std::abs(sum / draws - 21) < max_deviation * std::sqrt(42.0 / draws));
}

TEST_CASE("the heat of a thermostat is the change of kinetic energy, to rounding") {
  const scenes::Scene scene = tops(40);
  for (const ThermostatSettings& settings :
       {ThermostatSettings(Langevin{0, 3}), ThermostatSettings(Langevin{3, 3}),
        ThermostatSettings(Rescaling{0.2}), ThermostatSettings(SeparateRescaling{0.2})}) {
    CAPTURE(settings.index());
    State state = scene.state;
    remove_total_momentum(state, scene.bodies);
    const double before = energies(state, scene.bodies, Load{}).kinetic();
    Thermostat thermostat(settings, kelvin, scene.topology, scene.bodies, 3);
    for (std::uint64_t step = 0; step < 5; ++step) thermostat(state, 0.1, {step, 0});
    const double after = energies(state, scene.bodies, Load{}).kinetic();
    CHECK(thermostat.heat() == doctest::Approx(after - before).epsilon(1e-11));
  }
}

TEST_CASE("without friction, O leaves every bit of the momenta") {
  const scenes::Scene scene = tops(10);
  State state = scene.state;
  LangevinSettings settings = langevin(TotalMomentum::held);
  settings.friction = settings.rotational_friction = 0;
  CHECK(ornstein_uhlenbeck(state, scene.bodies, settings, 0.5, 1) == 0);
  for (std::size_t i = 0; i < state.size(); ++i) {
    CHECK(state.p[i] == scene.state.p[i]);
    CHECK(state.ell[i] == scene.state.ell[i]);
  }
}

TEST_CASE("O gives the same bits for any number of threads, and all instruction sets agree") {
  const scenes::Scene scene = tops(300);
  const auto thrown = [&](int threads) {
    Workers workers(threads);
    State state = scene.state;
    ornstein_uhlenbeck(state, scene.bodies, langevin(TotalMomentum::held), 0.2, 9, workers);
    return state;
  };
  const State one = thrown(1), three = thrown(3);
  for (std::size_t i = 0; i < one.size(); ++i) {
    CHECK(one.p[i] == three.p[i]);
    CHECK(one.ell[i] == three.ell[i]);
  }
  // log, sin and cos have errors of 3 units in the last place each, a rotation a few more.
  const InstructionSet current = current_instruction_set();
  for (const InstructionSet set : available_instruction_sets()) {
    force_instruction_set(set);
    const State other = thrown(1);
    for (std::size_t i = 0; i < one.size(); ++i) {
      CHECK(norm(one.p[i] - other.p[i]) < 40 * 0x1p-52 * (1 + norm(one.p[i])));
      CHECK(norm(one.ell[i] - other.ell[i]) < 40 * 0x1p-52 * (1 + norm(one.ell[i])));
    }
  }
  force_instruction_set(current);
}

// K' = c K + (1 − c) K̄/n (R² + S) + 2 R √(c (1 − c) K̄ K/n), with K̄ = n kT/2, has the mean
// c K + (1 − c) K̄ and the variance 2 n ((1 − c) K̄/n)² + 4 c (1 − c) K̄ K/n [bussi2007].
TEST_CASE("velocity rescaling lets the kinetic energy relax to its canonical distribution") {
  constexpr int draws = 40000;
  for (const double n : {1.0, 2.0, 9.0, 3069.0})
    for (const double ratio : {0.05, 1.0, 30.0})
      for (const double start : {0.3, 1.5}) {
        CAPTURE(n);
        CAPTURE(ratio);
        CAPTURE(start);
        const double mean_K = n * kT / 2, K = start * mean_K, c = std::exp(-ratio);
        double sum = 0, squares = 0;
        for (std::uint64_t draw = 0; draw < draws; ++draw) {
          const double a = rescaling_factor(K, n, kT, ratio, Random(11, draw));
          sum += a * a * K - K, squares += (a * a * K - K) * (a * a * K - K);
        }
        const double mean = sum / draws, variance = squares / draws - mean * mean;
        const double expected_mean = (1 - c) * (mean_K - K);
        const double expected_variance =
            2 * n * std::pow((1 - c) * mean_K / n, 2) + 4 * c * (1 - c) * mean_K * K / n;
        CHECK(std::abs(mean - expected_mean) <
              max_deviation * std::sqrt(expected_variance / draws));
        // The kurtosis of a sum of n squares is 3 + 12/n at most.
        CHECK(std::abs(variance / expected_variance - 1) <
              max_deviation * std::sqrt((2 + 12 / n) / draws));
      }
}

TEST_CASE("rescaling apart keeps the distributions of translation and of rotation") {
  const scenes::Scene scene = scenes::lattice({{"tip4p", 4}, {"co2", 4}}, 1, 100, 1);
  Thermostat thermostat(SeparateRescaling{0.1}, kelvin, scene.topology, scene.bodies, 3);
  State state = scene.state;
  remove_total_momentum(state, scene.bodies);
  double translation = 0, rotation = 0;
  constexpr int draws = 4000;
  for (std::uint64_t step = 0; step < draws; ++step) {
    thermostat(state, 1, {step, 0});  // c = e⁻¹⁰: draws are independent
    const Energies e = energies(state, scene.bodies, Load{});
    translation += e.translation * 2 / kT, rotation += (e.kinetic() - e.translation) * 2 / kT;
  }
  CHECK(std::abs(translation / draws - 21) < max_deviation * std::sqrt(2 * 21.0 / draws));
  CHECK(std::abs(rotation / draws - 20) < max_deviation * std::sqrt(2 * 20.0 / draws));
}

// A single atom in a field: three degrees of freedom.
TEST_CASE("where the total momentum is free, rescaling counts the motion of the centre of mass") {
  const scenes::Scene scene = scenes::lattice({{"argon", 1}}, 1, 100, 1);
  Thermostat thermostat(Rescaling{0.1}, kelvin, scene.topology, scene.bodies, 3, Workers::serial(),
                        TotalMomentum::free);
  State state = scene.state;
  double sum = 0;
  constexpr int draws = 4000;
  for (std::uint64_t step = 0; step < draws; ++step) {
    thermostat(state, 1, {step, 0});
    sum += norm2(state.p[0]) / (scene.bodies.m[0] * kT);
  }
  CHECK(std::abs(sum / draws - 3) < max_deviation * std::sqrt(6.0 / draws));
}

namespace {

constexpr double spring = 2000;  // to the origin for every body [kJ/mol/nm²]
void pull(const State& state, Load& load) {
  for (std::size_t i = 0; i < state.size(); ++i) load.f.set(i, -spring * state.q[i]);
}

struct Moments {
  double q = 0, p = 0, error = 0;  // relative to kT/k and m kT
};

// Argon on springs with frequency ω, step h, after many periods; ensemble of N bodies × samples.
Moments oscillators(const char* text, double omega_h) {
  const scenes::Scene scene = scenes::lattice({{"argon", 3000}}, 0, 100, 1);
  const double h = omega_h / std::sqrt(spring / scene.bodies.m[0]);
  const Langevin settings{0.5 / h, 0.5 / h};
  Thermostat thermostat(settings, kelvin, scene.topology, scene.bodies, 5, Workers::serial(),
                        TotalMomentum::free);
  const auto bath = [&](State& state, double t, StageNumber at) { thermostat(state, t, at); };
  Integrator integrator(scheme_of(text), scene.bodies, pull,
                        FreeDrift{scene.bodies, Workers::serial()}, bath);
  State state = scene.state;
  integrator.advance(state, h, 60);
  Moments moments;
  constexpr int samples = 10;
  for (int k = 0; k < samples; ++k) {
    integrator.advance(state, h, 30);  // 15 relaxation times of momenta
    for (std::size_t i = 0; i < state.size(); ++i)
      for (std::size_t c = 0; c < 3; ++c) {
        moments.q += state.q[i][c] * state.q[i][c] * spring / kT;
        moments.p += state.p[i][c] * state.p[i][c] / (scene.bodies.m[i] * kT);
      }
  }
  const double n = samples * 3.0 * double(state.size());
  return {moments.q / n, moments.p / n, std::sqrt(2 / n)};
}

}  // namespace

// With a step h, velocity Verlet conserves p²/2m + (1 − (ωh)²/4) k q²/2 at the ends of its steps;
// where the bath acts there, momenta are exact and positions have 1/(1 − (ωh)²/4). BAOAB has the
// positions exact and momenta 1 − (ωh)²/4 [leimkuhler2013].
TEST_CASE("oscillators in a bath have the variances that theory gives for the step") {
  for (const double x : {0.6, 1.4}) {
    CAPTURE(x);
    const double f = 1 - x * x / 4;
    const Moments obabo = oscillators("obabo", x), baoab = oscillators("baoab", x);
    CHECK(std::abs(obabo.q * f - 1) < max_deviation * obabo.error);
    CHECK(std::abs(obabo.p - 1) < max_deviation * obabo.error);
    CHECK(std::abs(baoab.q - 1) < max_deviation * baoab.error);
    CHECK(std::abs(baoab.p / f - 1) < max_deviation * baoab.error);
  }
}
