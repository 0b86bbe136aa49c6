// SPDX-License-Identifier: MIT
// The required accuracy of the mesh, and the accuracy reached.
#include "polhode/forces/mesh/mesh_choice.hpp"

#include <doctest/doctest.h>

#include <random>
#include <tuple>

#include "physics/mesh_scene.hpp"
#include "polhode/base/error.hpp"
#include "polhode/run/simulation/system/system.hpp"
#include "unit/errors.hpp"

using namespace polhode;

namespace {

// Every charge as a separate body: the mesh then gives the force on each.
struct LooseCharges {
  Topology topology;
  State state;
  std::vector<std::size_t> charge;  // of each body

  explicit LooseCharges(const PointCharges& charges, const Box& box) : state(charges.size(), box) {
    std::vector<double> kinds;
    for (const double q : charges.q)
      if (std::find(kinds.begin(), kinds.end(), q) == kinds.end()) kinds.push_back(q);
    for (const double q : kinds) {
      topology.parts.push_back({ion("loose", q), 0});
      for (std::size_t i = 0; i < charges.size(); ++i)
        if (charges.q[i] == q) {
          state.q.set(charge.size(), charges.r[i]);
          charge.push_back(i);
          ++topology.parts.back().count;
        }
    }
  }
};

struct Liquid {
  std::string name;
  Topology topology;
  State state;
};

Liquid water() {
  const System system = build_system(default_config());
  return {"water", system.topology, system.state};
}

// Some waters of a box replaced by ions, of both signs.
Liquid salt_water() {
  const Liquid all = water();
  constexpr std::size_t ions = 16;
  const std::size_t waters = all.state.size() - 2 * ions;
  Liquid salt{
      "salt water",
      {{{all.topology.parts[0].molecule, waters}, {ion("a", 1), ions}, {ion("b", -1), ions}}},
      all.state};
  for (std::size_t n = 0; n < 2 * ions; ++n) {  // from all over the box
    const std::size_t from = n * waters / (2 * ions), to = waters + n;
    const Vec3<double> q = salt.state.q[from];
    const Quaternion<double> orientation = salt.state.orientation[from];
    salt.state.q.set(from, salt.state.q[to]), salt.state.q.set(to, q);
    salt.state.orientation.set(from, salt.state.orientation[to]),
        salt.state.orientation.set(to, orientation);
  }
  return salt;
}

template <class T>
double rms_error(const Liquid& liquid, const MeshSettings& settings, const ExactMesh& exact) {
  const LooseCharges loose(point_charges(liquid.topology, liquid.state), liquid.state.box);
  BodyLoads loads;
  mesh_load<T>(loose.topology, loose.state, settings, loads);
  double sum = 0;
  for (std::size_t body = 0; body < loose.charge.size(); ++body)
    sum += norm2(loads.f[body] - exact.f[loose.charge[body]]);
  return std::sqrt(sum / double(loose.charge.size()));
}

}  // namespace

// The force on charges in water is the typical one; on ions in water, which the estimate treats as
// unscreened, somewhat larger. Suitable sizes of grids differ by up to a quarter, for which errors
// of order p to p + 2 differ up to 8 times; of grids twice as fine they would differ 30 to 500
// times.
TEST_CASE("the chosen mesh has the required accuracy, and not much more") {
  for (const Liquid& liquid : {water(), salt_water()}) {
    CAPTURE(liquid.name);
    for (const double cutoff : {0.9, 1.1})
      for (const double required : {1e-3, 1e-4, 1e-5, 1e-6}) {
        CAPTURE(cutoff);
        CAPTURE(required);
        const MeshSettings settings = mesh_for(required, cutoff, liquid.state.box, liquid.topology);
        CAPTURE(settings.points[0]);
        CAPTURE(settings.order);
        CAPTURE(settings.exponent);
        const ExactMesh exact(liquid.topology, liquid.state,
                              CompactSplit(cutoff, settings.exponent));
        const double typical = typical_force(liquid.topology, liquid.state.box);
        CHECK(typical > 0.7 * exact.rms);
        CHECK(typical < 1.1 * exact.rms);
        const double error = rms_error<double>(liquid, settings, exact) / exact.rms;
        CAPTURE(error);
        CHECK(error < required);
        CHECK(error > 0.1 * required);
        if (required < 1e-5) continue;
        const double rounded = rms_error<float>(liquid, settings, exact) / exact.rms;
        CAPTURE(rounded);
        CHECK(rounded < required);
        CHECK(rounded > 0.1 * required);
      }
  }
}

// The error estimate where its assumptions hold: molecules with random positions and orientations.
TEST_CASE("the expected error of a mesh is that of randomly placed bodies") {
  Liquid gas = water();
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> even;
  for (std::size_t i = 0; i < gas.state.size(); ++i) {
    const Vec3<double> at{even(random), even(random), even(random)};
    gas.state.q.set(i, scaled(at, gas.state.box.edge));
    gas.state.orientation.set(i, scenes::random_orientation(random));
  }
  for (const auto& [points, order, exponent] :
       {std::tuple{16, 4, 5}, {20, 5, 6}, {24, 6, 7}, {20, 7, 6}, {16, 8, 8}}) {
    const auto shown_order = order;
    CAPTURE(shown_order);
    const auto n = std::size_t(points);
    const MeshSettings settings{{n, n, n}, order, exponent, 0.9};
    const ExactMesh exact(gas.topology, gas.state, CompactSplit(0.9, exponent));
    const double ratio = rms_error<double>(gas, settings, exact) /
                         expected_mesh_error(gas.topology, gas.state.box, settings);
    CAPTURE(ratio);
    CHECK(ratio > 0.75);
    CHECK(ratio < 1.33);
  }
}

TEST_CASE("an impossible mesh is refused") {
  const Topology none{{{read_molecule("argon"), 5}}}, water{{{read_molecule("tip4p"), 5}}};
  const Box box{{2, 2, 2}};
  CHECK_THROWS_WITH_AS(mesh_for(1e-4, 0.9, box, none), doctest::Contains("no molecule"), Error);
  CHECK_THROWS_WITH_AS(mesh_for(0.5, 0.9, box, water), doctest::Contains("from 1e-7"), Error);
  using Mesh = ParticleMesh<double>;
  CHECK_THROWS_WITH_AS(Mesh(water, {{16, 6, 16}, 5, 6, 0.9}, box), doctest::Contains("6 points"),
                       Error);
  CHECK_THROWS_WITH_AS(Mesh(water, {{16, 16, 16}, 9, 6, 0.9}, box), doctest::Contains("order"),
                       Error);
  CHECK_THROWS_WITH_AS(Mesh(water, {{16, 16, 16}, 5, 0, 0.9}, box), doctest::Contains("exponent"),
                       Error);
}

// Two ions in 60 nm would need 540 points per edge, 2.5 GB for the energy of one pair.
TEST_CASE(
    "a mesh that is too large for few bodies in a large box is refused, with a suitable cutoff") {
  const Topology two{{{ion("a", 1), 1}, {ion("b", -1), 1}}};
  const Box box{{60, 60, 60}};
  check_error([&] { mesh_for(1e-4, 1.0, box, two); }, {"for 2 charges", "use a coulomb_cutoff of"});
  const MeshSettings far = mesh_for(1e-4, 12.0, box, two);
  CHECK(far.points[0] * far.points[1] * far.points[2] <= std::size_t{1} << 21);
  check_error(
      [&] {
        mesh_for(1e-4, 1.0, {{3000, 2.5, 2.5}}, two);
      },
      {"use a smaller box, or a larger pme_accuracy"});
}
