// SPDX-License-Identifier: MIT
// The particle mesh compared with direct sums, and for consistency: energy, forces, torques and
// virial agree with each other at any accuracy.
#include "forces/mesh/particle_mesh.hpp"

#include <doctest/doctest.h>

#include <set>

#include "forces/constant_terms.hpp"
#include "instruction_sets.hpp"
#include "physics/mesh_scene.hpp"

using namespace polhode;

namespace {

constexpr MeshSettings fine{{40, 44, 48}, 8, 9, 0.7};
constexpr MeshSettings coarse{{16, 20, 12}, 5, 6, 0.7};
constexpr MeshSettings large{{60, 64, 68}, 6, 6, 0.7};  // tiles are prefetched

double largest_distance(const std::vector<Vec3<double>>& a, const std::vector<Vec3<double>>& b) {
  double m = 0;
  for (std::size_t i = 0; i < a.size(); ++i) m = std::max(m, norm(a[i] - b[i]));
  return m;
}

// A body displaced, or rotated about a lab axis.
State moved(State state, std::size_t body, const Vec3<double>& by) {
  state.q.add(body, by);
  return state;
}
State turned(State state, std::size_t body, const Vec3<double>& axis, double angle) {
  const double s = std::sin(angle / 2);
  state.orientation.set(
      body, Quaternion<double>{std::cos(angle / 2), s * axis.x, s * axis.y, s * axis.z} *
                state.orientation[body]);
  return state;
}

double slope(const auto& energy, double h) {
  return (8 * (energy(h) - energy(-h)) - (energy(2 * h) - energy(-2 * h))) / (12 * h);
}

ConstantTerms mesh_constants(const scenes::Scene& scene, const MeshSettings& mesh) {
  ForceSettings settings;
  settings.electrostatics = Electrostatics::pme;
  settings.mesh = mesh;
  return constant_terms_of(scene.topology, settings, scene.state.box, 0);
}

}  // namespace

// A spacing of 0.042 nm and a split of C¹⁰ over 0.7 nm: the error estimate is 1e-7 of the forces.
TEST_CASE("on a fine grid the mesh is the smooth part of the Ewald sum") {
  const scenes::Scene scene = charged_mixture();
  const CompactSplit split(fine.cutoff, fine.exponent);
  const ExactMesh exact(scene.topology, scene.state, split);
  CHECK(std::abs(mesh_constants(scene, fine).background) > 0.1);
  for_each_instruction_set([&] {
    BodyLoads loads;
    const MeshLoad load = mesh_load<double>(scene.topology, scene.state, fine, loads);
    CHECK(std::abs(load.energy - exact.energy) < 1e-6 * std::abs(exact.energy));
    CHECK(largest_distance(loads.f, exact.bodies.f) < 3e-6 * exact.rms);
    CHECK(largest_distance(loads.tau, exact.bodies.tau) < 3e-7 * exact.rms);
    BodyLoads mixed;
    const MeshLoad rounded = mesh_load<float>(scene.topology, scene.state, fine, mixed);
    CHECK(std::abs(rounded.energy - exact.energy) < 1e-5 * std::abs(exact.energy));
    CHECK(largest_distance(mixed.f, exact.bodies.f) < 1e-5 * exact.rms);
    CHECK(largest_distance(mixed.tau, exact.bodies.tau) < 1e-6 * exact.rms);
    CHECK(largest_distance(mixed.f, exact.bodies.f) > 1e-8 * exact.rms);
  });
}

// The self, intramolecular and background terms of an Ewald sum.
TEST_CASE("the constant terms of a mesh are those of the Ewald sum") {
  const scenes::Scene scene = charged_mixture();
  const ConstantTerms constant = mesh_constants(scene, coarse);
  const CompactSplit split(coarse.cutoff, coarse.exponent);
  const EwaldEnergies e =
      ewald_sum(point_charges(scene.topology, scene.state), scene.state.box, split, {0.7, 0})
          .energy;
  CHECK(constant.self == doctest::Approx(e.self).epsilon(1e-13));
  CHECK(constant.intramolecular == doctest::Approx(e.intramolecular).epsilon(1e-13));
  CHECK(constant.background == doctest::Approx(e.background).epsilon(1e-13));
}

// The grid is so coarse that the energy has an error of 1e-3, but forces are still its gradient. A
// step of h = 1e-4 nm leaves h² of a third derivative that jumps at grid points, for the lowest
// order, and roundings of 10³ kJ/mol over h: 1e-8 kJ/mol/nm each, of forces of a hundred.
TEST_CASE("forces and torques of a mesh are minus the gradient of its energy") {
  const scenes::Scene scene = charged_mixture();
  for (int order = 4; order <= 8; ++order) {
    CAPTURE(order);
    MeshSettings settings = coarse;
    settings.order = order;
    BodyLoads loads;
    mesh_load<double>(scene.topology, scene.state, settings, loads);
    const auto energy = [&](const State& state) {
      BodyLoads ignored;
      return mesh_load<double>(scene.topology, state, settings, ignored).energy;
    };
    for (const std::size_t body : {3u, 31u, 40u})  // water, ion, linear
      for (std::size_t d = 0; d < 3; ++d) {
        Vec3<double> axis;
        axis[d] = 1;
        const auto along = [&](double h) { return energy(moved(scene.state, body, h * axis)); };
        CHECK(std::abs(slope(along, 1e-4) + loads.f[body][d]) < 1e-5);
        const auto about = [&](double h) { return energy(turned(scene.state, body, axis, h)); };
        CHECK(std::abs(slope(about, 1e-3) + loads.tau[body][d]) < 1e-5);
      }
    CHECK(norm(loads.f[3]) > 10);
    CHECK(norm(loads.tau[3]) > 0.1);
  }
}

// Boxes with two equal edges share influences by symmetry in one direction and not in the others.
TEST_CASE("the energy of a mesh does not depend on which edge of a slab is the long one") {
  const scenes::Scene scene = charged_mixture();
  const double a = scene.state.box.shortest_edge();
  const MeshSettings settings{{20, 20, 20}, 6, 9, 0.7};
  const Quaternion<double> turn{0.5, 0.5, 0.5, 0.5};  // x to y, y to z, z to x
  State state = scene.state;
  state.box = Box{{a, a, 1.3 * a}};
  std::array<double, 3> energies{};
  for (double& energy : energies) {
    BodyLoads ignored;
    energy = mesh_load<double>(scene.topology, state, settings, ignored).energy;
    const Vec3<double> edge = state.box.edge;
    state.box = Box{{edge.z, edge.x, edge.y}};
    for (std::size_t i = 0; i < state.size(); ++i) {
      const Vec3<double> q = state.q[i];
      state.q.set(i, {q.z, q.x, q.y});
      state.orientation.set(i, turn * state.orientation[i]);
    }
  }
  CHECK(std::abs(energies[0]) > 1);
  for (const double energy : energies) CHECK(energy == doctest::Approx(energies[0]).epsilon(1e-11));
}

// Centres and box are scaled alike, orientations kept. Along one edge alone the shape of the box
// changes, which the influence function's correction follows only to the accuracy of the mesh.
TEST_CASE("the virial of a mesh is the derivative of its energy with respect to the volume") {
  const scenes::Scene scene = charged_mixture();
  const auto energy = [&](const MeshSettings& settings, const Vec3<double>& strain) {
    State state = scene.state;
    const Vec3<double> scale = Vec3<double>{1, 1, 1} + strain;
    state.box = Box{scaled(scale, state.box.edge)};
    for (std::size_t i = 0; i < state.size(); ++i) state.q.set(i, scaled(scale, scene.state.q[i]));
    BodyLoads ignored;
    return mesh_load<double>(scene.topology, state, settings, ignored).energy;
  };
  for (const MeshSettings& settings : {coarse, fine}) {
    BodyLoads loads;
    const Mat3<double> virial =
        mesh_load<double>(scene.topology, scene.state, settings, loads).virial;
    const double trace = virial[0].x + virial[1].y + virial[2].z;
    CHECK(std::abs(trace) > 10);
    const auto even = [&](double h) { return energy(settings, {h, h, h}); };
    CHECK(std::abs(slope(even, 2e-4) + trace) < 1e-7 * std::abs(trace));
    for (std::size_t d = 0; d < 3; ++d) {
      const auto along = [&](double h) {
        Vec3<double> strain;
        strain[d] = h;
        return energy(settings, strain);
      };
      const double accuracy = settings.order == fine.order ? 1e-6 : 1e-3;
      CHECK(std::abs(slope(along, 2e-4) + virial[d][d]) < accuracy * std::abs(trace));
    }
  }
  // Off the diagonal: that of the direct sum, minus the contribution of the arms.
  const ExactMesh exact(scene.topology, scene.state, CompactSplit(fine.cutoff, fine.exponent));
  const PointCharges charges = point_charges(scene.topology, scene.state);
  Mat3<double> expected = exact.virial;
  for (std::size_t i = 0; i < charges.size(); ++i)
    for (std::size_t d = 0; d < 3; ++d)
      expected[d] -= (charges.r[i] - scene.state.q[charges.body[i]])[d] * exact.f[i];
  BodyLoads loads;
  const MeshLoad load = mesh_load<double>(scene.topology, scene.state, fine, loads);
  CHECK(largest_difference(load.virial, expected) < 1e-6 * largest(expected));
}

TEST_CASE("the mesh gives the same bits for any number of threads") {
  const scenes::Scene scene = charged_mixture();
  const auto check = [&]<class T>(T) {
    for (const MeshSettings& settings : {coarse, fine, large}) {
      BodyLoads one;
      const MeshLoad load = mesh_load<T>(scene.topology, scene.state, settings, one);
      for (const int threads : {2, 3, 7}) {
        CAPTURE(threads);
        Workers workers(threads);
        BodyLoads many;
        const MeshLoad other = mesh_load<T>(scene.topology, scene.state, settings, many, workers);
        CHECK(other.energy == load.energy);
        CHECK(largest_difference(other.virial, load.virial) == 0);
        CHECK(many.f == one.f);
        CHECK(many.tau == one.tau);
      }
    }
  };
  check(double());
  check(float());
}

// Threads fill all even slabs, or all odd ones, at the same time.
TEST_CASE("charges of slabs that are not adjacent have no tile of the grid in common") {
  const scenes::Scene scene = charged_mixture();
  const MeshScene<double> records(scene.topology, scene.state);
  for (int order = MeshSettings::min_order; order <= MeshSettings::max_order; ++order)
    for (std::size_t ny = MeshSettings::max_order; ny <= 60; ny += mesh_multiple) {
      CAPTURE(order);
      CAPTURE(ny);
      MeshCharges<double> charges(scene.topology, {{16, ny, 16}, order, 6, 0.7});
      charges.place(records.list.slots(), records.records, nullptr, scene.state.box,
                    Workers::serial());
      std::vector<std::set<std::size_t>> tiles(charges.slabs());
      std::size_t placed = 0;
      for (std::size_t slab = 0; slab < charges.slabs(); ++slab)
        for (const std::uint32_t number : charges.in_slab(slab)) {
          ++placed;
          const double y = charges.records()[number * ChargeRecord::stride + 1];
          const auto point = static_cast<std::size_t>(std::floor(y) + double(ny)) % ny;
          for (std::size_t k = 0; k < static_cast<std::size_t>(order); ++k)
            tiles[slab].insert((point + k) % ny / mesh_multiple);
        }
      CHECK(placed == 30 * 3 + 3 + 9 * 3 + 2);
      for (std::size_t a = 0; a < tiles.size(); ++a)
        for (std::size_t b = a + 2; b < tiles.size(); b += 2)
          for (const std::size_t tile : tiles[a]) CHECK(!tiles[b].contains(tile));
    }
}

// A body just outside of the box, on either side, as before a rebuild of the list.
TEST_CASE(
    "the energy of a mesh does not depend on the position of the bodies relative to the box") {
  const scenes::Scene scene = charged_mixture();
  for (const MeshSettings& settings : {coarse, fine, large}) {
    BodyLoads here;
    const double energy = mesh_load<double>(scene.topology, scene.state, settings, here).energy;
    // Displacements by whole grid spacings change nothing except rounding.
    State there = scene.state;
    for (std::size_t i = 0; i < there.size(); ++i)
      for (std::size_t d = 0; d < 3; ++d) {
        const double spacing = there.box.edge[d] / double(settings.points[d]);
        Vec3<double> by;
        by[d] = spacing * (d == 0 ? 3 : d == 1 ? -4 : 7);
        there.q.add(i, by);
      }
    for_each_instruction_set([&] {
      BodyLoads loads;
      const MeshLoad load = mesh_load<double>(scene.topology, there, settings, loads);
      CHECK(std::abs(load.energy - energy) < 1e-12 * std::abs(energy));
      CHECK(largest_distance(loads.f, here.f) < 1e-10);
      BodyLoads rounded;
      const MeshLoad mixed = mesh_load<float>(scene.topology, there, settings, rounded);
      CHECK(std::abs(mixed.energy - energy) < 1e-5 * std::abs(energy));
      CHECK(largest_distance(rounded.f, here.f) < 1e-2);
    });
  }
}
