// SPDX-License-Identifier: MIT
#include "polhode/ensemble/minimise.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "polhode/base/units.hpp"
#include "polhode/run/prepare/preparation.hpp"
#include "run/simulation/system/relaxation.hpp"

using namespace polhode;

namespace {

System system_of(const std::string& model, int count, const std::string& box, int seed = 1) {
  return build_system(parse_config("[system]\nmolecules = [{ model = \"" + model +
                                       "\", count = " + std::to_string(count) + " }]\nbox = \"" +
                                       box + "\"\nseed = " + std::to_string(seed) +
                                       "\n[forces]\ncutoff = \"0.9 nm\"\n",
                                   "run.toml"));
}

Load load_of(const System& system) {
  ForceField forces(system.topology, system.forces, system.state.box);
  Load load(system.state.size());
  forces(system.state, load);
  return load;
}

bool same_bits(const State& a, const State& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!(a.q[i] == b.q[i] && a.orientation[i] == b.orientation[i])) return false;
  return true;
}

}  // namespace

TEST_CASE("two argon atoms reach the minimum of the Lennard-Jones potential") {
  System argon = system_of("argon", 2, "2.5 nm");
  argon.state.q.set(0, {0, 0, 0});
  argon.state.q.set(1, {0.25, 0.2, 0.1});
  const Site site = argon.topology.parts[0].molecule.sites[0];
  const double bound = 1e-7;
  const Minimisation result = minimise(argon, {.force = bound});
  CHECK(result.end == MinimisationEnd::converged);
  CHECK(result.after.force <= bound);
  // The curvature at the minimum is 57.1 ε/σ²; the energy is quadratic in the distance from it.
  const double curvature = 57.1 * site.epsilon / (site.sigma * site.sigma);
  const double r = norm(argon.state.q[1] - argon.state.q[0]);
  CHECK(std::abs(r - std::pow(2, 1.0 / 6) * site.sigma) < 1.01 * bound / curvature + 1e-15);
  CHECK(result.after.potential == doctest::Approx(-site.epsilon).epsilon(1e-14));
  CHECK(result.after.potential == doctest::Approx(load_of(argon).potential()).epsilon(1e-14));
}

// -6.24 kcal/mol [jorgensen1983]. The tolerance is half of its last digit, and the difference of
// the Coulomb constant, 332.18 kcal/mol Å/e² there and 332.06 here, times at most 35 kJ/mol.
TEST_CASE("the best of the minima of two TIP4P waters is the published dimer") {
  double lowest = 0;
  for (int seed = 1; seed <= 6; ++seed) {
    System water = system_of("tip4p", 2, "2.5 nm", seed);
    water.state.q.set(0, {0, 0, 0});
    water.state.q.set(1, {0.3, 0, 0});
    const Minimisation result = minimise(water, {.force = 1e-6, .torque = 1e-7});
    CHECK(result.end == MinimisationEnd::converged);
    const Load load = load_of(water);
    for (std::size_t i = 0; i < 2; ++i) {
      CHECK(norm(load.f[i]) <= 1e-6);
      CHECK(norm(load.tau[i]) <= 1e-7);
    }
    CHECK(result.after.potential < result.before.potential);
    lowest = std::min(lowest, result.after.potential);
  }
  CHECK(std::abs(lowest - -6.24 * 4.184) < 0.005 * 4.184 + 35 * (332.18 / 332.06 - 1));
}

TEST_CASE("no move is longer than the cap, and the cap is reached where molecules overlap") {
  System water = system_of("tip4p", 40, "2 nm", 3);
  const double extent = water.topology.parts[0].molecule.extent(), cap = 0.004;
  water.state.q.set(1, water.state.q[0] + Vec3<double>{0.1, 0, 0});
  State before = water.state;
  double farthest = 0, widest = 0;
  minimise(water, {.max_steps = 60, .max_move = cap}, [&](std::size_t, const Steepness&) {
    for (std::size_t i = 0; i < before.size(); ++i) {
      farthest = std::max(farthest, norm(water.state.q[i] - before.q[i]));
      const Quaternion<double> turn = conjugate(before.orientation[i]) * water.state.orientation[i];
      widest = std::max(widest, 2 * std::asin(norm(Vec3<double>{turn.x, turn.y, turn.z})) * extent);
    }
    before = water.state;
    return false;
  });
  // A step downhill may follow half a step back.
  CHECK(farthest <= 1.5 * cap * (1 + 1e-12));
  CHECK(farthest >= cap * (1 - 1e-12));
  // The angular velocity changes along the free rotation, by a part of the angle, 0.04.
  CHECK(widest <= 1.5 * cap * 1.04);
  CHECK(widest >= 0.9 * cap);
}

TEST_CASE("a minimisation has the same bits for any number of threads") {
  System one = system_of("tip4p", 64, "2 nm"), three = one;
  Workers workers(3);
  const MinimisationSettings few{.max_steps = 40};
  CHECK(minimise(one, few).end == MinimisationEnd::max_steps);
  minimise(three, few, {}, workers);
  CHECK(same_bits(one.state, three.state));
}

TEST_CASE("within the bounds nothing moves, and the callback ends a minimisation") {
  System water = system_of("tip4p", 27, "2 nm");
  const State before = water.state;
  const double infinite = std::numeric_limits<double>::infinity();
  CHECK(minimise(water, {.force = infinite, .torque = infinite}).steps == 0);
  const auto at_once = [](std::size_t, const Steepness&) { return true; };
  CHECK(minimise(water, {}, at_once).end == MinimisationEnd::stopped);
  CHECK(same_bits(water.state, before));
}

TEST_CASE("momenta are 0 afterwards; a system keeps them in the body frame") {
  System co2 = system_of("co2", 27, "2 nm");
  System kept = co2;
  ForceField forces(co2.topology, co2.forces, co2.state.box);
  minimise(co2.state, co2.topology, co2.bodies,
           [&](const State& at, Load& load) { forces(at, load); }, {.max_steps = 30});
  minimise(kept, {.max_steps = 30});
  CHECK(same_bits(co2.state, kept.state));
  const System start = system_of("co2", 27, "2 nm");
  for (std::size_t i = 0; i < start.state.size(); ++i) {
    CHECK(norm(co2.state.p[i]) == 0);
    CHECK(norm(co2.state.ell[i]) == 0);
    const Vec3<double> L = to_body(start.state.orientation[i], start.state.ell[i]);
    CHECK(norm(to_body(kept.state.orientation[i], kept.state.ell[i]) - L) < 1e-14 * (1 + norm(L)));
  }
}

// A sphere of diameter σ for each atom; the points of the count err by less than a layer of half
// their spacing, 0.01 nm, on a radius of 0.17 nm.
TEST_CASE("the density of a liquid is estimated from the diameters of sites") {
  const Topology argon = system_of("argon", 5, "2.5 nm").topology;
  const Molecule& atom = argon.parts[0].molecule;
  const double sphere = units::pi / 6 * std::pow(atom.sites[0].sigma, 3);
  CHECK(std::abs(estimated_density(argon) / (0.45 * atom.mass / sphere) - 1) < 3 * 0.005 / 0.17);
  // Spheres of one molecule overlap; sites without a short-range law have none.
  // Sites without σ: the Buckingham potential of argon is 0 at 0.3399 nm, by bisection of its
  // formula.
  const double other = estimated_density(system_of("argon-buckingham", 5, "2.5 nm").topology);
  CHECK(other / estimated_density(argon) ==
        doctest::Approx(std::pow(0.3405 / 0.3399, 3)).epsilon(2 * 3 * 0.005 / 0.17));
  const double water = estimated_density(system_of("tip4p", 5, "2.5 nm").topology);
  CHECK(water == doctest::Approx(0.45 * 18.0154 / (units::pi / 6 * std::pow(0.315365, 3)))
                     .epsilon(3 * 0.005 / 0.157));
}

TEST_CASE("atoms at the same place are an error that names them") {
  System argon = system_of("argon", 3, "2.5 nm");
  argon.state.q.set(1, argon.state.q[2]);
  try {
    minimise(argon);
    FAIL("no error");
  } catch (const RunError& e) {
    CHECK(std::string(e.what()).find("not a finite number") != std::string::npos);
  }
}
