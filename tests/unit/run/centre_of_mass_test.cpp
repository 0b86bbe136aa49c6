// SPDX-License-Identifier: MIT
// The motion of the centre of mass: removed, and not counted anywhere.
#include "polhode/model/centre_of_mass.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "measure/displacement.hpp"
#include "measure/velocity_correlation.hpp"
#include "model/initial_state.hpp"
#include "polhode/base/units.hpp"
#include "polhode/measure/energy.hpp"
#include "polhode/run/simulation/system/system.hpp"
#include "scenes.hpp"

using namespace polhode;

namespace {

scenes::Scene mixture(std::size_t n) {
  return scenes::spread(
      {{{read_molecule("tip4p"), n}, {read_molecule("argon"), n}, {read_molecule("n2"), n}}},
      {3, 4, 5}, 3);
}

void add_velocity(State& state, const Bodies& bodies, const Vec3<double>& v) {
  for (std::size_t i = 0; i < state.size(); ++i) state.p.add(i, bodies.m[i] * v);
}

double largest(const Vec3Column& v) {
  double max_size = 0;
  for (std::size_t i = 0; i < v.size(); ++i) max_size = std::max(max_size, norm(v[i]));
  return max_size;
}

const Vec3<double> common{1, -2, 0.5};  // [nm/ps]

}  // namespace

// Each of n additions rounds a sum that is at most n times the largest term, and so does each
// subtraction of a share.
TEST_CASE("total momentum and net force are removed in proportion to the masses") {
  for (const std::size_t n : {std::size_t{1}, std::size_t{20}, std::size_t{4000}}) {
    scenes::Scene scene = mixture(n);
    const State before = scene.state;
    add_velocity(scene.state, scene.bodies, common);
    const Vec3<double> own = total_momentum(before) / total_mass(scene.bodies);
    const Vec3<double> removed = remove_total_momentum(scene.state, scene.bodies);
    const double rounding = 4 * 0x1p-53 * double(scene.state.size());
    CHECK(norm(removed - own - common) < rounding * norm(removed));
    const double sum = double(scene.state.size()) * (largest(before.p) + 100 * norm(common));
    CHECK(norm(total_momentum(scene.state)) < rounding * sum);
    for (std::size_t i = 0; i < scene.state.size(); ++i)
      CHECK(norm(scene.state.p[i] - before.p[i] + scene.bodies.m[i] * own) <
            rounding * largest(scene.state.p));

    Load load(scene.state.size());
    load.f = before.p;
    load.tau = before.ell;
    Load many = load;
    remove_net_force(load, scene.bodies);
    Workers workers(3);
    remove_net_force(many, scene.bodies, workers);
    Vec3<double> net{};
    for (std::size_t i = 0; i < load.f.size(); ++i) {
      net += load.f[i];
      CHECK(load.f[i] == many.f[i]);
      CHECK(load.tau[i] == before.ell[i]);
    }
    CHECK(norm(net) < rounding * largest(load.f));
  }
}

TEST_CASE("a single body is brought to rest exactly, and no force moves it") {
  const Topology water{{{read_molecule("tip4p"), 1}}};
  const Bodies bodies(water);
  State state(1, Box{{2, 2, 2}});
  state.p.set(0, {0.1, 0.7, -1e9 / 3});
  const Vec3<double> p = state.p[0];
  CHECK(norm(remove_total_momentum(state, bodies) - p / bodies.m[0]) <= 1e-15 * norm(p));
  CHECK(state.p[0] == Vec3<double>{});
  Load load(1);
  load.f.set(0, {1.0 / 3, 0.1, 7});
  remove_net_force(load, bodies);
  CHECK(load.f[0] == Vec3<double>{});
}

// With the velocity u, Σ p²/2m − P²/2M loses only the digits of M u²/2.
TEST_CASE("energies and pressure do not depend on a common velocity") {
  scenes::Scene scene = mixture(50);
  remove_total_momentum(scene.state, scene.bodies);
  const Energies rest = energies(scene.state, scene.bodies, Load{});
  const Mat3<double> pressure = pressure_tensor(scene.state, scene.bodies, Load{});
  double plain = 0;
  for (std::size_t i = 0; i < scene.state.size(); ++i)
    plain += norm2(scene.state.p[i]) / (2 * scene.bodies.m[i]);
  CHECK(rest.translation == doctest::Approx(plain).epsilon(1e-13));
  add_velocity(scene.state, scene.bodies, common);
  const Energies moving = energies(scene.state, scene.bodies, Load{});
  const double whole = total_mass(scene.bodies) * norm2(common) / 2;
  const double rounding = 8 * 0x1p-53 * 150 * (whole + rest.translation);
  CHECK(whole > 5 * rest.translation);  // it would be detected
  CHECK(std::abs(moving.translation - rest.translation) < rounding);
  CHECK(std::abs(moving.pressure - rest.pressure) < rounding);
  const Mat3<double> same = pressure_tensor(scene.state, scene.bodies, Load{});
  for (std::size_t k = 0; k < 3; ++k)
    CHECK(norm(same[k] - pressure[k]) < 4 * rounding / scene.state.box.volume());
}

// Bodies that all move equally have neither displacements nor velocities; for one that moves
// relative to the others they are reduced by its fraction of the mass.
TEST_CASE("displacements and velocity correlations are those relative to the centre of mass") {
  const Topology topology{{{read_molecule("argon"), 3}}};
  const Bodies bodies(topology);
  State state(3, Box{{2, 2, 2}});
  for (std::size_t i = 0; i < 3; ++i) state.q.set(i, {0.3 * double(i), 0.5, 0.7});
  add_velocity(state, bodies, common);
  const auto moved = [&](const Vec3<double>& own) {
    State now = state;
    now.p.add(0, bodies.m[0] * own);
    Displacement displacement(topology, 4);
    VelocityCorrelation velocities(topology, 4);
    for (int frame = 0; frame < 16; ++frame) {
      displacement.add(now);
      velocities.add(now);
      for (std::size_t i = 0; i < 3; ++i) now.q.add(i, 0.01 * now.p[i] / bodies.m[i]);
    }
    return std::pair(displacement.mean_square(0).mean(), velocities.linear(0).mean());
  };
  const auto [still, no_velocity] = moved({});
  for (std::size_t lag = 0; lag < 4; ++lag) {
    CHECK(std::abs(still[lag]) < 1e-13);
    CHECK(std::abs(no_velocity[lag]) < 1e-13);
  }
  // The mean square of (2/3, −1/3, −1/3) u over three bodies is 2/9 u².
  const Vec3<double> own{0.3, 0.1, 0};
  const auto [some, velocity] = moved(own);
  for (std::size_t lag = 0; lag < 4; ++lag) {
    const double way = 0.01 * double(lag) * norm(own);
    CHECK(some[lag] == doctest::Approx(2.0 / 9 * way * way).epsilon(1e-9));
    CHECK(velocity[lag] == doctest::Approx(2.0 / 9 * norm2(own) / 3).epsilon(1e-9));
  }
}

// 3 N − 3 for any N: momenta are drawn, rescaled and measured at the same temperature.
TEST_CASE(
    "momenta of one, two and many bodies are drawn, rescaled and measured at the same "
    "temperature") {
  for (const char* name : {"tip4p", "n2", "argon"})
    for (const std::size_t n : {1u, 2u, 30u}) {
      CAPTURE(std::string(name));
      CAPTURE(n);
      const Topology topology{{{read_molecule(name), n}}};
      const Bodies bodies(topology);
      const DegreesOfFreedom own = degrees_of_freedom(topology);
      CHECK(own.translation == 3 * double(n) - 3);
      State state = lattice(topology, {{3, 3, 3}}, 1);
      draw_momenta(state, topology, 297, 2);
      const auto read = [&] {
        const Energies e = energies(state, bodies, Load{});
        return mean_temperatures(e, own);
      };
      const double expected = own.all() > 0 ? 297 : 0;
      CHECK(read().all == doctest::Approx(expected).epsilon(1e-12));
      CHECK(norm(total_momentum(state)) <= 4 * 0x1p-53 * double(n) * largest(state.p));
      add_velocity(state, bodies, common);
      CHECK(read().all == doctest::Approx(expected).epsilon(1e-11));
      rescale(state, topology, bodies, 350);
      CHECK(read().all == doctest::Approx(own.all() > 0 ? 350 : 0).epsilon(1e-12));
      if (own.translation > 0) CHECK(read().translation == doctest::Approx(350).epsilon(1e-12));
    }
}
