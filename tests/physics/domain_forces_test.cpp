// SPDX-License-Identifier: MIT
// The forces on the bodies of domains, each with its ghosts, are those of the whole periodic
// system, and so are the sums of their energies and virials.
#include <doctest/doctest.h>

#include <array>

#include "ewald.hpp"
#include "instruction_sets.hpp"
#include "physics/force_laws.hpp"
#include "polhode/base/error.hpp"
#include "polhode/forces/domain_forces.hpp"
#include "polhode/forces/force_field.hpp"

using namespace polhode;

namespace {

// A part of the box, and which bodies it has.
struct Domain {
  Topology own;
  std::vector<std::size_t> ghosts;   // number of each kind
  std::vector<std::size_t> bodies;   // of the scene, in the order of the domain's: own, then ghosts
  std::vector<Vec3<double>> shifts;  // of their images
};

// Each pair of bodies of two domains, or of two images, is computed once: by the domain that has
// the image with positive numbers of edges, or else by the earlier domain.
bool computes(const Vec3<double>& cell, bool body_is_in_later_domain) {
  for (std::size_t e = 0; e < 3; ++e)
    if (cell[e] != 0) return cell[e] > 0;
  return body_is_in_later_domain;
}

// Ghosts that may interact: images within the range of the domain's bounds.
double range_of(const Topology& topology, const ForceSettings& settings) {
  double extent = 0;
  for (const auto& part : topology.parts) extent = std::max(extent, part.molecule.extent());
  return settings.cutoff + 2 * extent;
}

// Space from x = `low` to `high`, in edges of the box, with the bodies wrapped into the box; no
// ghosts are images in directions with a period.
Domain domain(const scenes::Scene& scene, double low, double high, double range,
              const Vec3<double>& period) {
  Domain d;
  for (const auto& part : scene.topology.parts) {
    d.own.parts.push_back({part.molecule, 0});
    d.ghosts.push_back(0);
  }
  const Vec3<double> edge = scene.state.box.edge;
  std::vector<std::size_t> ghosts;
  std::vector<Vec3<double>> ghost_shifts;
  for (std::size_t i = 0; i < scene.state.size(); ++i) {
    const Vec3<double> q = scene.state.q[i];
    const Vec3<double> home{-std::floor(q.x / edge.x), -std::floor(q.y / edge.y),
                            -std::floor(q.z / edge.z)};
    for (int image = 0; image < 125; ++image) {
      const Vec3<double> cell{image % 5 - 2.0, image / 5 % 5 - 2.0, image / 25 - 2.0};
      const Vec3<double> shift = scaled(home + cell, edge), at = q + shift;
      const std::size_t part = scene.bodies.part[i];
      if (cell == Vec3<double>{} && at.x >= low * edge.x && at.x < high * edge.x) {
        ++d.own.parts[part].count;
        d.bodies.push_back(i);
        d.shifts.push_back(shift);
        continue;
      }
      const Vec3<double> first{low * edge.x, 0, 0}, last{high * edge.x, edge.y, edge.z};
      bool near = true;
      for (std::size_t e = 0; e < 3; ++e)
        near = near &&
               (period[e] > 0 ? cell[e] == 0 : at[e] > first[e] - range && at[e] < last[e] + range);
      if (!near || !computes(cell, (q + scaled(home, edge)).x >= high * edge.x)) continue;
      ++d.ghosts[part];
      ghosts.push_back(i);
      ghost_shifts.push_back(shift);
    }
  }
  d.bodies.insert(d.bodies.end(), ghosts.begin(), ghosts.end());
  d.shifts.insert(d.shifts.end(), ghost_shifts.begin(), ghost_shifts.end());
  return d;
}

// Sums over the domains of the forces on its bodies and ghosts.
Load sum_of_domains(const scenes::Scene& scene, const ForceSettings& settings,
                    const std::vector<double>& bounds, const Vec3<double>& period = {}) {
  const double range = range_of(scene.topology, settings);
  Load sum(scene.state.size());
  for (std::size_t k = 0; k + 1 < bounds.size(); ++k) {
    const Domain d = domain(scene, bounds[k], bounds[k + 1], range, period);
    DomainForces forces(d.own, d.ghosts, settings, period);
    for (std::size_t i = 0; i < d.bodies.size(); ++i) {
      forces.state().q.set(i, scene.state.q[d.bodies[i]] + d.shifts[i]);
      forces.state().orientation.set(i, scene.state.orientation[d.bodies[i]]);
    }
    Load load;
    forces(load, true);
    for (std::size_t i = 0; i < d.bodies.size(); ++i) {
      sum.f.add(d.bodies[i], load.f[i]);
      sum.tau.add(d.bodies[i], load.tau[i]);
    }
    sum.van_der_waals += load.van_der_waals;
    sum.coulomb += load.coulomb;
    for (std::size_t r = 0; r < 3; ++r) sum.virial[r] += load.virial[r];
  }
  return sum;
}

// Each R is the difference of two coordinates within two edges of the origin, rounded to 2⁻⁵³ of
// them, and a force of a contact of 0.25 nm changes by 13/0.25 nm relatively; sums add a few
// hundred roundings.
void check_same(const Load& a, const Load& b, double edge) {
  const double scale = std::max({largest(b.f), largest(b.virial), std::abs(b.van_der_waals)});
  const double bound = 0x1p-53 * (500 + 16 * edge * 13 / 0.25) * scale;
  CHECK(largest_difference(a.f, b.f) <= bound);
  CHECK(largest_difference(a.tau, b.tau) <= bound);
  CHECK(std::abs(a.van_der_waals - b.van_der_waals) <= bound);
  CHECK(std::abs(a.coulomb - b.coulomb) <= bound);
  CHECK(largest_difference(a.virial, b.virial) <= bound);
}

const std::vector<std::vector<double>> divisions = {{0, 1}, {0, 0.5, 1}, {0, 0.05, 0.1, 0.4, 1}};

}  // namespace

TEST_CASE("domains with ghosts have the forces and the energies of the periodic system") {
  const scenes::Scene scene = mixture();
  for (const NamedLaw& law : all_laws()) {
    CAPTURE(law.name);
    const Load whole = load_of(scene.topology, law.settings, scene.state);
    for (const auto& bounds : divisions) {
      CAPTURE(bounds.size());
      check_same(sum_of_domains(scene, law.settings, bounds), whole, scene.state.box.edge.x);
    }
  }
}

TEST_CASE("images in periodic directions need no ghosts") {
  const scenes::Scene scene = mixture();
  const Vec3<double> edge = scene.state.box.edge;
  for (const NamedLaw& law : all_laws()) {
    CAPTURE(law.name);
    const Load whole = load_of(scene.topology, law.settings, scene.state);
    check_same(sum_of_domains(scene, law.settings, {0, 1}, edge), whole, edge.x);
    for (const Vec3<double>& period : {Vec3<double>{0, edge.y, edge.z}, Vec3<double>{0, 0, edge.z}})
      for (const auto& bounds : divisions)
        check_same(sum_of_domains(scene, law.settings, bounds, period), whole, edge.x);
  }
}

TEST_CASE("a period must be long enough for one image of each body") {
  const Topology argon{{{read_molecule("argon"), 2}}};
  const ForceSettings settings{Truncation::site_switch, 0.9, 0.8};
  const double shortest = 2 * settings.cutoff;
  CHECK(DomainForces::is_long_enough(shortest, argon, settings));
  CHECK(!DomainForces::is_long_enough(shortest * (1 - 1e-12), argon, settings));
  CHECK_THROWS_WITH_AS(DomainForces(argon, {2}, settings, {0, 0, 0.99 * shortest}),
                       doctest::Contains("half of the shortest box edge"), Error);
}

TEST_CASE("domains of water agree for every instruction set, also in mixed precision") {
  const scenes::Scene scene = scenes::lattice({{"tip4p", 216}}, 0.31, 1.86, 5);
  ForceSettings settings{Truncation::molecule_switch, 0.75, 0.6};
  settings.electrostatics = Electrostatics::reaction_field;
  for_each_instruction_set([&] {
    const Load whole = load_of(scene.topology, settings, scene.state);
    check_same(sum_of_domains(scene, settings, {0, 0.3, 1}), whole, scene.state.box.edge.x);
    ForceSettings mixed = settings;
    mixed.precision = Precision::mixed;
    const Load rounded = sum_of_domains(scene, mixed, {0, 0.3, 1});
    // As in mixed precision without domains, up to the resolution of their larger boxes.
    const double error = largest_difference(rounded.f, whole.f);
    const double usual = largest_difference(load_of(scene.topology, mixed, scene.state).f, whole.f);
    CAPTURE(usual);
    CHECK(error < 3 * usual);
    CHECK(error > usual / 3);
  });
}

TEST_CASE("bodies of a domain may move between evaluations, and it may be empty") {
  const scenes::Scene scene = scenes::lattice({{"tip4p", 64}}, 0.31, 1.24, 5);
  const ForceSettings settings{Truncation::molecule_switch, 0.6, 0.5};
  const Topology none{{{scene.topology.parts[0].molecule, 0}}};
  DomainForces forces(scene.topology, {0}, settings);
  Load load, fresh;
  for (const double scale : {1.0, 1.3, 1.8, 20.0}) {  // out of the first box, and apart
    DomainForces anew(scene.topology, {}, settings);
    for (DomainForces* each : {&forces, &anew})
      for (std::size_t i = 0; i < scene.state.size(); ++i) {
        each->state().q.set(i, scale * scene.state.q[i]);
        each->state().orientation.set(i, scene.state.orientation[i]);
      }
    forces(load, true);
    anew(fresh, true);
    check_same(load, fresh, scale * 1.24);
    CHECK((scale > 10) == (largest(load.f) == 0));
  }
  DomainForces empty(none, {64}, settings);
  empty(load, true);
  CHECK(load.potential() == 0);
  CHECK(empty.own_bodies() == 0);
}

TEST_CASE("ghosts have the kinds of the local bodies") {
  const Topology two{{{read_molecule("argon"), 2}, {read_molecule("tip4p"), 1}}};
  const ForceSettings settings{Truncation::site_switch, 0.9, 0.8};
  CHECK_NOTHROW(DomainForces(two, {0, 3}, settings));
  CHECK_NOTHROW(DomainForces(two, {}, settings));
  CHECK_THROWS_WITH_AS(DomainForces(two, {3}, settings),
                       doctest::Contains("ghosts of 1 kinds in DomainForces, which has 2 kinds"),
                       Error);
}

TEST_CASE("the smooth part of Ewald's split is a polynomial") {
  const double cutoff = 0.9;
  for (const double x : {0.5, 2.0, 3.0, 4.0, max_gaussian}) {
    CAPTURE(x);
    const GaussianSplit split{x / cutoff};
    const SmoothPolynomial polynomial = gaussian_smooth_part(cutoff, split.alpha);
    // The terms left out are below 1e-11 up to α a = 4, and grow to 1e-9 at the largest.
    const double bound = x <= 4 ? 1e-12 : 1e-9;
    for (double r = 0.05; r < cutoff; r += 0.01) {
      CHECK(std::abs(polynomial.smooth(r).u - split.smooth(r).u) < bound / cutoff);
      CHECK(std::abs(polynomial.smooth(r).s - split.smooth(r).s) <
            1e3 * bound / (cutoff * cutoff * cutoff));
    }
  }
  CHECK_THROWS_AS(gaussian_smooth_part(1, 1.01 * max_gaussian), Error);
  CHECK_THROWS_AS(gaussian_smooth_part(1, 0), Error);
}

TEST_CASE("pairs of the Ewald sum together with the mesh of another program") {
  const Molecule water = read_molecule("tip4p");
  ForceSettings settings{Truncation::site_switch, 0.9, 0.8};
  settings.electrostatics = Electrostatics::pme;
  settings.ewald_alpha = 3.2;
  DomainForces forces(Topology{{{water, 1}}}, {1}, settings);
  const Vec3<double> R{0.1, 0.3, 0.05};
  forces.state().q.set(1, R);
  Load load;
  forces(load, true);
  const GaussianSplit split{3.2};
  double pairs = 0, within = 0;
  const auto& sites = water.sites;
  for (std::size_t a = 0; a < sites.size(); ++a)
    for (std::size_t b = 0; b < sites.size(); ++b) {
      const double q = units::coulomb * sites[a].charge * sites[b].charge;
      pairs += q * split.pair(norm(R + sites[b].r - sites[a].r)).u;
      if (a < b) within -= q * split.smooth(norm(sites[b].r - sites[a].r)).u;
    }
  // The mesh has the self-energy, but not the correction within a molecule.
  CHECK(load.coulomb == doctest::Approx(pairs + within).epsilon(1e-11));
  CHECK(norm(load.f[0] + load.f[1]) <= 1e-14 * norm(load.f[0]));
  // A force field has its own mesh.
  Workers& workers = Workers::serial();
  CHECK_THROWS_WITH_AS(ForceField({{{water, 1}}}, settings, Box{{3, 3, 3}}, workers),
                       doctest::Contains("ewald_alpha"), Error);
}
