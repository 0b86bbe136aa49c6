// SPDX-License-Identifier: MIT
// The long-range dispersion of a slab: against a sum over planes, and against its own derivatives.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <functional>

#include "forces/laws/slab_dispersion.hpp"
#include "physics/force_laws.hpp"
#include "polhode/forces/domain_forces.hpp"
#include "polhode/math/rotation.hpp"
#include "unit/errors.hpp"

using namespace polhode;

namespace {

const ForceSettings settings_of_slab{.truncation = Truncation::molecule_switch,
                                     .cutoff = 0.8,
                                     .switch_from = 0.7,
                                     .slab_dispersion = true};

/// Molecules of several sites; the same system in a longer box has a density that depends on z.
scenes::Scene molecules() {
  scenes::Scene scene = scenes::spread(
      {{{read_molecule("co2"), 20}, {read_molecule("benzene"), 5}, {read_molecule("tip4p"), 20}}},
      {2, 2, 2}, 4);
  scene.state.box.edge.z = 6.1;
  return scene;
}

Load load_of_slab(const scenes::Scene& scene, const State& state) {
  Load load(state.size());
  SlabDispersion(scene.topology, settings_of_slab, state.box).add(state, load, true);
  return load;
}

/// The derivative of a function at 0, to fourth order.
double derivative(const std::function<double(double)>& f, double h) {
  return (8 * (f(h) - f(-h)) - (f(2 * h) - f(-2 * h))) / (12 * h);
}

State moved(State state, std::size_t i, const Vec3<double>& dq, const Vec3<double>& dtheta) {
  state.q.add(i, dq);
  state.orientation.set(i, normalized(state.orientation[i] * rotation_quaternion(dtheta)));
  return state;
}

}  // namespace

// Two planes at the distance z have the energy 2π ∫ u r dr per site and area, from the cutoff or
// from z if it is longer [janecek2006]. A logistic profile of width 0.5 nm has no waves shorter
// than 0.3 nm, so only the points of the quadrature and its end at 12 cutoffs are left: below 1e-4.
TEST_CASE("the energy of a slab is the sum over pairs of planes") {
  constexpr std::size_t n = 400;
  const Topology argon{{{read_molecule("argon"), n}}};
  const ForceSettings settings{.truncation = Truncation::site_switch,
                               .cutoff = 0.9,
                               .switch_from = 0.9 - 1e-6,
                               .slab_dispersion = true};
  const Box box{{2.5, 2.4, 9}};
  State state(n, box);
  for (std::size_t i = 0; i < n; ++i) {
    const double u = (static_cast<double>(i) + 0.5) / n;
    state.q.set(i, {0, 0, 4 + 0.5 * std::log(u / (1 - u))});
  }
  const Site& site = argon.parts[0].molecule.sites[0];
  const auto [c6, c12] = LennardJones<>::of(site.sigma, site.epsilon);
  const auto of_planes = [&, c6 = c6, c12 = c12](double z) {
    const double r2 = std::pow(std::max(settings.cutoff, std::abs(z)), 2);
    return 2 * units::pi * (c12 / (10 * std::pow(r2, 5)) - c6 / (4 * r2 * r2));
  };
  double expected = 0;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      for (int image = -12; image <= 12; ++image)
        expected += of_planes(state.q[i].z - state.q[j].z + image * box.edge.z);
  expected /= 2 * box.edge.x * box.edge.y;
  Load load(n);
  SlabDispersion(argon, settings, box).add(state, load, true);
  const double found = load.van_der_waals + dispersion_tail(argon, settings) / box.volume();
  CHECK(found == doctest::Approx(expected).epsilon(1e-4));
  CHECK(std::abs(load.van_der_waals / expected) > 0.3);  // a uniform density gives much less
}

TEST_CASE("forces and torques of a slab are minus the derivatives of its energy") {
  const scenes::Scene scene = molecules();
  const Load load = load_of_slab(scene, scene.state);
  const double scale = largest(load.f);
  REQUIRE(scale > 0.1);
  for (const std::size_t i : {std::size_t{0}, std::size_t{22}, std::size_t{30}})
    for (std::size_t d = 0; d < 3; ++d) {
      Vec3<double> way{};
      way[d] = 1;
      const auto along = [&](const Vec3<double>& dq, const Vec3<double>& dtheta) {
        return derivative(
            [&](double h) {
              return load_of_slab(scene, moved(scene.state, i, h * dq, h * dtheta)).van_der_waals;
            },
            1e-3);
      };
      CHECK(std::abs(along(way, {}) + load.f[i][d]) < 1e-7 * scale);
      const Vec3<double> torque = to_body(scene.state.orientation[i], load.tau[i]);
      CHECK(std::abs(along({}, way) + torque[d]) < 1e-7 * scale);
    }
}

// The strain moves the centres and keeps orientations, as the virial of all forces.
TEST_CASE("the virial of a slab is the change of its energy when the box is strained") {
  const scenes::Scene scene = molecules();
  const Load load = load_of_slab(scene, scene.state);
  for (std::size_t d = 0; d < 3; ++d) {
    const auto energy = [&](double strain) {
      State state = scene.state;
      Vec3<double> factor{1, 1, 1};
      factor[d] += strain;
      state.box.edge = scaled(factor, state.box.edge);
      for (std::size_t i = 0; i < state.size(); ++i) state.q.set(i, scaled(factor, state.q[i]));
      return load_of_slab(scene, state).van_der_waals;
    };
    CHECK(std::abs(derivative(energy, 1e-4) + load.virial[d][d]) < 1e-6 * largest(load.virial));
  }
  CHECK(std::abs(load.virial[2][2] - load.virial[0][0]) > 0.1 * largest(load.virial));
}

TEST_CASE("the derivative along a displacement is the change of forces and torques") {
  const scenes::Scene scene = molecules();
  const std::size_t n = scene.state.size();
  Vec3Column dq(n), dtheta(n);
  for (std::size_t i = 0; i < n; ++i) {
    const auto x = static_cast<double>(i);
    dq.set(i, {std::sin(x), std::cos(3 * x), std::sin(5 * x)});
    dtheta.set(i, {std::cos(x), std::sin(2 * x), std::cos(7 * x)});
  }
  Load slope(n);
  SlabDispersion(scene.topology, settings_of_slab, scene.state.box)
      .add_derivative(scene.state, dq, dtheta, slope);
  std::array<Load, 4> loads;
  constexpr double h = 1e-3;
  constexpr std::array places{2 * h, h, -h, -2 * h};
  for (std::size_t k = 0; k < 4; ++k) {
    State state = scene.state;
    for (std::size_t i = 0; i < n; ++i)
      state = moved(state, i, places[k] * dq[i], places[k] * dtheta[i]);
    loads[k] = load_of_slab(scene, state);
  }
  const auto check = [&](Vec3Column Load::*column) {
    const double scale = largest(slope.*column);
    REQUIRE(scale > 0);
    for (std::size_t i = 0; i < n; ++i) {
      const auto at = [&](std::size_t k) { return (loads[k].*column)[i]; };
      const Vec3<double> numeric = (8 * (at(1) - at(2)) - (at(0) - at(3))) / (12 * h);
      CHECK(norm(numeric - (slope.*column)[i]) < 1e-6 * scale);
    }
  };
  check(&Load::f);
  check(&Load::tau);
}

TEST_CASE("a force field adds the modes of a slab to the uniform dispersion") {
  const scenes::Scene scene = molecules();
  ForceSettings uniform = settings_of_slab, slab = settings_of_slab;
  uniform.slab_dispersion = false;
  uniform.dispersion_correction = true;
  const Load modes = load_of_slab(scene, scene.state);
  const Load one = load_of(scene.topology, uniform, scene.state),
             other = load_of(scene.topology, slab, scene.state);
  CHECK(other.van_der_waals - one.van_der_waals == doctest::Approx(modes.van_der_waals));
  CHECK(other.virial[2].z - one.virial[2].z == doctest::Approx(modes.virial[2].z));
  for (std::size_t i = 0; i < scene.state.size(); ++i)
    CHECK(norm(other.f[i] - one.f[i] - modes.f[i]) < 1e-12 * largest(one.f));
}

TEST_CASE("unsuitable settings of slab_dispersion are refused") {
  const scenes::Scene scene = molecules();
  ForceSettings both = settings_of_slab, shifted = settings_of_slab;
  both.dispersion_correction = true;
  shifted.truncation = Truncation::site_shift;
  const auto make = [&](const ForceSettings& s) {
    return [&] { ForceField(scene.topology, s, scene.state.box); };
  };
  check_error(make(both), {"slab_dispersion", "assumes a uniform density"});
  check_error(make(shifted), {"slab_dispersion", "site-switch"});
  check_error([&] { DomainForces(scene.topology, {}, settings_of_slab, scene.state.box.edge); },
              {"slab_dispersion needs all bodies", "leave"});
}
