// SPDX-License-Identifier: MIT
// The derivative of forces and torques along a displacement: compared with dual numbers summed over
// all pairs, with differences of forces and energies for a mesh, and its symmetry.
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "instruction_sets.hpp"
#include "physics/force_laws.hpp"
#include "physics/mesh_scene.hpp"
#include "polhode/integrate/flows.hpp"
#include "polhode/integrate/rodrigues.hpp"
#include "polhode/model/centre_of_mass.hpp"

using namespace polhode;

namespace {

// Centres by about a nm, orientations by about 10 rad: both then move sites equally.
struct Direction {
  Vec3Column dq, dtheta;

  Direction(std::size_t bodies, unsigned seed) : dq(bodies), dtheta(bodies) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    for (std::size_t i = 0; i < bodies; ++i)
      for (Vec3Column* column : {&dq, &dtheta}) {
        const double scale = column == &dq ? 1 : 10;
        const double x = normal(random), y = normal(random), z = normal(random);
        column->set(i, scale * Vec3<double>{x, y, z});
      }
  }
  /// The same, with the centre of mass fixed.
  Direction at_rest(const Bodies& bodies) const {
    Direction u = *this;
    const Vec3<double> common = centre_of_mass(dq, bodies);
    for (std::size_t i = 0; i < dq.size(); ++i) u.dq.add(i, -common);
    return u;
  }
  /// A state moved by t times this.
  State of(State state, double t) const {
    for (std::size_t i = 0; i < state.size(); ++i) {
      state.q.set(i, state.q[i] + t * dq[i]);
      state.orientation.set(i, state.orientation[i] * rodrigues(t * dtheta[i]));
    }
    return state;
  }
};

double rms(const Vec3Column& a) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += norm2(a[i]);
  return std::sqrt(sum / double(a.size()));
}
double rms_difference(const Vec3Column& a, const Vec3Column& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += norm2(a[i] - b[i]);
  return std::sqrt(sum / double(a.size()));
}

// The work of forces and torques along a displacement, orientations in the lab frame.
double work(const Load& load, const State& state, const Direction& u) {
  double sum = 0;
  for (std::size_t i = 0; i < state.size(); ++i)
    sum += dot(load.f[i], u.dq[i]) + dot(load.tau[i], to_lab(state.orientation[i], u.dtheta[i]));
  return sum;
}

ForceSettings with_mesh(const MeshSettings& mesh) {
  ForceSettings settings{Truncation::site_switch, 0.75, 0.6, 3, Electrostatics::pme};
  settings.skin = 0.05;
  settings.mesh = mesh;
  return settings;
}

// All laws and kinds of bodies: charges on a mesh, atoms and ions.
std::vector<NamedLaw> mesh_laws() {
  std::vector<NamedLaw> laws;
  // Charges with the same cutoff as the short-range law, a shorter and a longer one.
  for (int order = MeshSettings::min_order; order <= MeshSettings::max_order; ++order)
    laws.push_back(
        {"mesh of order " + std::to_string(order), with_mesh({.points = {16, 20, 16},
                                                              .order = order,
                                                              .exponent = 6,
                                                              .cutoff = order == 5   ? 0.55
                                                                        : order == 6 ? 0.79
                                                                                     : 0.75})});
  return laws;
}

}  // namespace

// In double precision both are the same sums up to rounding: as for forces in pair_engine_test,
// with one more power of the distance. In float, positions rounded by 2⁻²⁴ nm change forces by
// Terms::f2_of_places, the derivative of each term for 1 nm, times 2⁻²⁴. Rounding of a term of the
// derivative of power n along about 3 nm is (n + 2)/2 times the rounding of r² and a little more:
// about 10 units in total. This is only an estimate: 0.02 to 3.3 times it was observed, where
// single contacts dominate and terms of both signs cancel. A wrong term has an error of 1e6 times
// it, pairs in double 1e-8.
TEST_CASE(
    "the derivative over the list equals dual numbers over all pairs, for every instruction set") {
  const scenes::Scene scene = mixture();
  const Direction u(scene.state.size(), 5);
  for (const NamedLaw& law : all_laws()) {
    CAPTURE(law.name);
    const Load exact =
        reference_derivative(scene.topology, law.settings, scene.state, u.dq, u.dtheta);
    const double bound = 0x1p-53 * (500 + 8 * scene.state.box.edge.x * 14 / 0.25);
    const double rounded = 10 * std::sqrt(terms_of(scene, law.settings).f2_of_places);
    for_each_instruction_set([&] {
      Load slope;
      ForceField(scene.topology, law.settings, scene.state.box)
          .directional_derivative(scene.state, u.dq, u.dtheta, slope);
      CHECK(slope.potential() == 0);
      CHECK(largest(slope.virial) == 0);
      CHECK(largest_difference(slope.f, exact.f) < bound * largest(exact.f));
      CHECK(largest_difference(slope.tau, exact.tau) < bound * largest(exact.f));

      ForceSettings mixed = law.settings;
      mixed.precision = Precision::mixed;
      ForceField(scene.topology, mixed, scene.state.box)
          .directional_derivative(scene.state, u.dq, u.dtheta, slope);
      const double f = rms_difference(slope.f, exact.f) / rounded;
      const double tau = rms_difference(slope.tau, exact.tau) / rounded;
      CAPTURE(f);
      CAPTURE(tau);
      CHECK(f < 10);
      CHECK(f > 0.005);
      CHECK(tau < 3);
      CHECK(tau > 0.0005);  // arms of 0.1 nm
    });
  }
}

// Unrolled shapes: the mixture above has TIP4P's.
TEST_CASE("the derivative of waters of three and five sites equals dual numbers over all pairs") {
  for (const char* model : {"tip3p", "tip5p"}) {
    CAPTURE(std::string(model));
    const scenes::Scene scene = scenes::spread({{{read_molecule(model), 40}}}, {1.7, 1.6, 1.6}, 8);
    const Direction u(scene.state.size(), 6);
    for (const Truncation truncation :
         {Truncation::molecule_switch, Truncation::site_switch, Truncation::site_shift}) {
      const ForceSettings settings{truncation, 0.7, 0.6, 2, Electrostatics::reaction_field,
                                   78.5,       0.05};
      const Load exact =
          reference_derivative(scene.topology, settings, scene.state, u.dq, u.dtheta);
      for_each_instruction_set([&] {
        ForceField forces(scene.topology, settings, scene.state.box);
        Load slope;
        forces.directional_derivative(scene.state, u.dq, u.dtheta, slope);
        CHECK(largest_difference(slope.f, exact.f) < 1e-13 * largest(exact.f));
        CHECK(largest_difference(slope.tau, exact.tau) < 1e-13 * largest(exact.tau));
      });
    }
  }
}

// A central difference of fourth order over moves of h = 1e-5 nm errs by h⁴/30 of the fifth
// derivative, (13/0.25 nm)⁵ of a contact's force, 1e-13, over the first one, and by rounding over
// h: 2⁻⁵³ × 10³ × 0.25/1e-5 = 3e-9 of the derivative at worst. The derivative is that of the mesh
// forces, whatever their deviation from the Ewald sum: for splines of order 4 the second derivative
// bends at grid points, which a charge may pass within 2 h: a change of h/spacing = 1e-4 of the
// contribution of one charge, which does not happen here.
TEST_CASE("with a mesh the derivative is the slope of forces and torques") {
  const scenes::Scene scene = charged_mixture();
  const Direction u(scene.state.size(), 7);
  constexpr double h = 1e-5;
  for (const NamedLaw& law : mesh_laws()) {
    CAPTURE(law.name);
    const auto at = [&](double t) {
      return load_of(scene.topology, law.settings, u.of(scene.state, t));
    };
    const Load p1 = at(h), m1 = at(-h), p2 = at(2 * h), m2 = at(-2 * h);
    Load numeric(scene.state.size());
    for (std::size_t i = 0; i < scene.state.size(); ++i) {
      const auto difference = [&](auto member) {
        return (8.0 / (12 * h)) * (member(p1)[i] - member(m1)[i]) -
               (1.0 / (12 * h)) * (member(p2)[i] - member(m2)[i]);
      };
      numeric.f.set(i, difference([](const Load& l) -> const Vec3Column& { return l.f; }));
      numeric.tau.set(i, difference([](const Load& l) -> const Vec3Column& { return l.tau; }));
    }
    for_each_instruction_set([&] {
      ForceField forces(scene.topology, law.settings, scene.state.box);
      Load slope;
      forces.directional_derivative(scene.state, u.dq, u.dtheta, slope);
      CHECK(largest_difference(slope.f, numeric.f) < 1e-8 * largest(numeric.f));
      CHECK(largest_difference(slope.tau, numeric.tau) < 1e-8 * largest(numeric.tau));

      ForceSettings rounded = law.settings;
      rounded.precision = Precision::mixed;
      ForceField in_float(scene.topology, rounded, scene.state.box);
      Load approximate;
      in_float.directional_derivative(scene.state, u.dq, u.dtheta, approximate);
      const double f = rms_difference(approximate.f, slope.f) / rms(slope.f);
      CAPTURE(f);
      CHECK(f < 0x1p-24 * 200);  // as above, and sums over the grid
      CHECK(f > 0x1p-24 * 0.1);
    });
  }
}

// The potential on the mesh is reused if the charges are those of the last evaluation, and only
// then.
TEST_CASE("the derivative does not depend on earlier evaluations") {
  const scenes::Scene scene = charged_mixture();
  const Direction u(scene.state.size(), 8);
  const ForceSettings settings = mesh_laws()[2].settings;
  Load fresh, again, load;
  ForceField(scene.topology, settings, scene.state.box)
      .directional_derivative(scene.state, u.dq, u.dtheta, fresh);
  ForceField forces(scene.topology, settings, scene.state.box);
  const auto check = [&] {
    forces.directional_derivative(scene.state, u.dq, u.dtheta, again);
    CHECK(largest_difference(again.f, fresh.f) == 0);
    CHECK(largest_difference(again.tau, fresh.tau) == 0);
  };
  forces(scene.state, load);
  check();
  check();
  forces(u.of(scene.state, 1e-4), load);
  check();
  State turned = scene.state;
  turned.orientation.set(3, turned.orientation[3] * rodrigues({0, 0.1, 0}));
  forces(turned, load);
  check();
}

// Second derivatives of V along rotations a and b about lab axes differ by their commutator
// (docs/theory.md): with D_u the derivative along u, u·D_v(f, τ) − v·D_u(f, τ) = Σ (a_u × a_v)·τ;
// with a mesh only if the centre of mass is fixed, where forces are a gradient. Both sides are sums
// of about 10³ terms of both signs, exact up to rounding: 2⁻⁵³ × √10³ × 10 of their size.
TEST_CASE("the derivative is symmetric except for the commutator of rotations") {
  const auto check = [](const scenes::Scene& scene, const std::vector<NamedLaw>& laws) {
    const State& state = scene.state;
    const auto u = Direction(state.size(), 9).at_rest(scene.bodies);
    const auto v = Direction(state.size(), 10).at_rest(scene.bodies);
    for (const NamedLaw& law : laws) {
      CAPTURE(law.name);
      ForceField forces(scene.topology, law.settings, state.box);
      Load load, along_u, along_v;
      forces(state, load);
      forces.directional_derivative(state, u.dq, u.dtheta, along_u);
      forces.directional_derivative(state, v.dq, v.dtheta, along_v);
      double commutator = 0, scale = 0;
      for (std::size_t i = 0; i < state.size(); ++i) {
        const auto lab = [&](const Direction& d) {
          return to_lab(state.orientation[i], d.dtheta[i]);
        };
        commutator += dot(cross(lab(u), lab(v)), load.tau[i]);
        scale += norm(along_v.f[i]) * norm(u.dq[i]) + norm(along_v.tau[i]) * norm(lab(u));
      }
      CHECK(std::abs(commutator) > 1e-8 * scale);
      CHECK(std::abs(work(along_v, state, u) - work(along_u, state, v) - commutator) <
            1e-12 * scale);
    }
  };
  check(mixture(), all_laws());
  check(charged_mixture(), mesh_laws());
}

// Along u twice, d²V/dt² = −u·D_u(f, τ). A central second difference of fourth order errs by h⁴/90
// of the sixth derivative and by rounding of V over h²: at h = 1e-4 nm, where contacts change over
// 0.25/12 nm, by (5e-3)⁴/90 = 7e-12 and 2⁻⁵³ × 10/(5e-3)² = 4e-11 of the terms, whose sum is some
// ten times smaller. Switches of class 3 and splines of order 8 are smooth enough.
TEST_CASE("the derivative is the second derivative of the energy") {
  const auto check = [](const scenes::Scene& scene, const std::vector<NamedLaw>& laws) {
    const auto u = Direction(scene.state.size(), 11).at_rest(scene.bodies);
    constexpr double h = 5e-5;
    for (const NamedLaw& law : laws) {
      if (law.settings.smoothness < 3) continue;
      if (law.settings.mesh && law.settings.mesh->order < 8) continue;
      CAPTURE(law.name);
      const auto energy = [&](double t) {
        return load_of(scene.topology, law.settings, u.of(scene.state, t)).potential();
      };
      const double second =
          (16 * (energy(h) + energy(-h)) - (energy(2 * h) + energy(-2 * h)) - 30 * energy(0)) /
          (12 * h * h);
      ForceField forces(scene.topology, law.settings, scene.state.box);
      Load slope;
      forces.directional_derivative(scene.state, u.dq, u.dtheta, slope);
      CHECK(-work(slope, scene.state, u) == doctest::Approx(second).epsilon(1e-6));
    }
  };
  check(mixture(), all_laws());
  check(charged_mixture(), mesh_laws());
}
