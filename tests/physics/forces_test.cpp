// SPDX-License-Identifier: MIT
// Laws that hold for every force field: over truncations, classes of the switch and kinds of
// bodies.
#include <doctest/doctest.h>

#include <cmath>

#include "forces/pairs/neighbours.hpp"
#include "math/dual.hpp"
#include "physics/force_laws.hpp"
#include "polhode/base/units.hpp"
#include "polhode/integrate/integrator.hpp"
#include "polhode/integrate/schemes.hpp"
#include "reference_forces.hpp"

using namespace polhode;

// dU = −Σ f·dq + τ·dθ for any displacement. The derivative of U comes from dual numbers, exact to
// rounding, so both sides agree up to rounding: sums of about 10³ pair terms of up to 10⁴
// kJ/mol/nm.
TEST_CASE("force and torque are minus the gradient of the energy, for every law and body") {
  const scenes::Scene scene = mixture();
  for (const NamedLaw& law : all_laws()) {
    CAPTURE(law.name);
    ForceField forces(scene.topology, law.settings, scene.state.box);
    Load load;
    forces(scene.state, load);
    for (std::size_t i = 0; i < scene.state.size(); ++i) {
      CAPTURE(i);
      for (std::size_t k = 0; k < 3; ++k) {
        Vec3Column dq(scene.state.size()), none(scene.state.size()), dtheta(scene.state.size());
        Vec3<double> e{};
        e[k] = 1;
        dq.set(i, e);
        dtheta.set(i, to_body(scene.state.orientation[i], e));
        const auto along = [&](const Vec3Column& by, const Vec3Column& turn) {
          return reference_derivative(scene.topology, law.settings, scene.state, by, turn);
        };
        const Load by_moving = along(dq, none), by_turning = along(none, dtheta);
        CHECK(std::abs(by_moving.potential() + load.f[i][k]) < 1e-13 * largest(load.f));
        CHECK(std::abs(by_turning.potential() + load.tau[i][k]) < 1e-13 * largest(load.f));
      }
    }
  }
}

// The directional derivative against a central difference of fourth order: h⁴ f⁽⁵⁾ against
// rounding/h leaves 1e-8 of the derivative at h = 1e-4 nm for contacts with a length scale of about
// 0.02 nm.
TEST_CASE("the directional derivative is the slope of forces and torques") {
  const scenes::Scene scene = mixture();
  for (const NamedLaw& law : all_laws()) {
    if (law.settings.smoothness < 3) continue;  // a central difference needs the fifth derivative
    CAPTURE(law.name);
    ForceField forces(scene.topology, law.settings, scene.state.box);
    Load load;
    forces(scene.state, load);
    const std::size_t n = scene.state.size();
    Vec3Column dq(n), dtheta(n);
    for (std::size_t i = 0; i < n; ++i) {
      dq.set(i, scene.bodies.inverse_m[i] * load.f[i]);
      dtheta.set(
          i, scaled(scene.bodies.inverse_J[i], to_body(scene.state.orientation[i], load.tau[i])));
    }
    Load slope;
    forces.directional_derivative(scene.state, dq, dtheta, slope);
    const auto at = [&](double c) {
      State moved = scene.state;
      displace(moved, scene.bodies, load, c);
      Load there;
      forces(moved, there);
      return there;
    };
    const double h = 2e-7;  // the largest f/m is about 300, J⁻¹τ 3000: displacements of 1e-4 nm
    const Load p1 = at(h), m1 = at(-h), p2 = at(2 * h), m2 = at(-2 * h);
    for (std::size_t i = 0; i < n; ++i) {
      const auto numeric = [&](auto member) {
        return (8.0 / (12 * h)) * (member(p1)[i] - member(m1)[i]) -
               (1.0 / (12 * h)) * (member(p2)[i] - member(m2)[i]);
      };
      const Vec3<double> df = numeric([](const Load& l) -> const Vec3Column& { return l.f; });
      const Vec3<double> dtau = numeric([](const Load& l) -> const Vec3Column& { return l.tau; });
      CHECK(norm(df - slope.f[i]) < 1e-6 * largest(slope.f));
      CHECK(norm(dtau - slope.tau[i]) < 1e-6 * largest(slope.f));
    }
  }
}

// A run at high temperature with many rebuilds of the list, forces compared with all pairs, in a
// box whose edge is just above twice the cutoff.
TEST_CASE("the neighbour list misses no pair in a long run at high temperature") {
  for (const Truncation truncation : {Truncation::molecule_switch, Truncation::site_switch}) {
    scenes::Scene scene = scenes::lattice({{"tip4p", 60}, {"argon", 20}}, 0.36, 1.61, 5);
    for (std::size_t i = 0; i < scene.state.size(); ++i)
      scene.state.p.set(
          i, 2.0 * scene.state.p[i]);  // 1200 K: hotter, hydrogen meets a charge of another water
    const ForceSettings settings{truncation, 0.8, 0.65, 2, Electrostatics::reaction_field,
                                 78.5,       0.06};
    ForceField forces(scene.topology, settings, scene.state.box);
    Integrator integrator(schemes[1], scene.bodies, forces);
    for (int k = 0; k < 60; ++k) {
      integrator.advance(scene.state, 0.0005, 20);
      const Load& load = integrator.load(scene.state);
      const auto exact =
          reference_load(scene.topology, settings, scene.state.box, scenes::poses(scene.state));
      CHECK(largest_difference(load.f, exact.f) < 1e-12 * largest(load.f));
    }
    CHECK(forces.neighbours().rebuilds() > 10);
  }
}

// Forces are invariant if all bodies are shifted, one is shifted by a box edge, or all are rotated
// about z by 90 degrees. Positions change by rounding of up to 10 nm × 2⁻⁵³, forces by that times
// f'.
TEST_CASE(
    "forces do not depend on the origin, the choice of periodic images, or the orientation of the "
    "axes") {
  for (const Truncation truncation : {Truncation::molecule_switch, Truncation::site_switch}) {
    const scenes::Scene scene = mixture();
    const ForceSettings settings{truncation, 0.8, 0.65, 2, Electrostatics::reaction_field,
                                 78.5,       0.1};
    const Load base = load_of(scene.topology, settings, scene.state);
    State shifted = scene.state, turned = scene.state;
    const Quaternion<double> quarter{std::sqrt(0.5), 0, 0, std::sqrt(0.5)};
    for (std::size_t i = 0; i < scene.state.size(); ++i) {
      const Vec3<double> images{double(i % 3) - 1, double(i % 5) - 2, -double(i % 2)};
      shifted.q.set(i, scene.state.q[i] + Vec3<double>{0.123, -4.56, 0.789} +
                           scaled(images, scene.state.box.edge));
      turned.q.set(i, to_lab(quarter, scene.state.q[i]));
      turned.orientation.set(i, quarter * scene.state.orientation[i]);
    }
    const Load by_shift = load_of(scene.topology, settings, shifted),
               by_turn = load_of(scene.topology, settings, turned);
    const double scale = largest(base.f);
    for (std::size_t i = 0; i < scene.state.size(); ++i) {
      CHECK(norm(by_shift.f[i] - base.f[i]) < 1e-11 * scale);
      CHECK(norm(by_turn.f[i] - to_lab(quarter, base.f[i])) < 1e-11 * scale);
      CHECK(norm(by_turn.tau[i] - to_lab(quarter, base.tau[i])) < 1e-11 * scale);
    }
    CHECK(by_shift.potential() == doctest::Approx(base.potential()).epsilon(1e-11));
  }
}

// Two point charges and two atoms by hand.
TEST_CASE("a pair of sites feels the textbook energies inside the switch") {
  Topology ions{
      {{rigid_molecule("cation", {{.name = "C", .mass = 20, .charge = 1}}), 1},
       {rigid_molecule("atom",
                       {{.name = "A", .mass = 30, .charge = -0.5, .sigma = 0.3, .epsilon = 0.8}}),
        2}}};
  State state(3, Box{{10, 10, 10}});
  state.q.set(0, {0, 0, 0});
  state.q.set(1, {0.4, 0, 0});
  state.q.set(2, {0.4, 0.35, 0});
  ForceField forces(ions, {Truncation::molecule_switch, 2, 1.8, 2, Electrostatics::coulomb, 1, 0.1},
                    state.box);
  Load load;
  forces(state, load);
  const double s6 = std::pow(0.3 / 0.35, 6);
  CHECK(load.van_der_waals == doctest::Approx(4 * 0.8 * (s6 * s6 - s6)).epsilon(1e-14));
  const double r02 = std::hypot(0.4, 0.35);
  CHECK(load.coulomb ==
        doctest::Approx(units::coulomb * (-0.5 / 0.4 - 0.5 / r02 + 0.25 / 0.35)).epsilon(1e-14));
}
