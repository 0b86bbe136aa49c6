// SPDX-License-Identifier: MIT
#include "run/simulation/system/relaxation.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "../errors.hpp"
#include "forces/pairs/overlap.hpp"
#include "polhode/base/error.hpp"
#include "polhode/measure/energy.hpp"
#include "polhode/run/simulation/simulation.hpp"
#include "polhode/run/simulation/trajectory/trajectory.hpp"

using namespace polhode;

namespace {

Config benzene(const std::string& density, const std::string& cutoff, int seed) {
  return parse_config(R"([system]
molecules = [{ model = "benzene", count = 40 }]
temperature = "300 K"
density = ")" + density +
                          "\"\nseed = " + std::to_string(seed) + R"(
[forces]
cutoff = ")" + cutoff + R"("
[run]
equilibrate = "1 ps"
)",
                      "benzene.toml");
}

bool overlaps(const System& system) {
  try {
    check_overlap(system.topology, system.state);
    return false;
  } catch (const Error&) {
    return true;
  }
}

double kinetic_temperature(const System& system) {
  return temperature(energies(system.state, system.bodies, Load{}).kinetic(),
                     degrees_of_freedom(system.topology).all());
}

}  // namespace

TEST_CASE("a lattice of benzene at the density of the liquid is moved apart and equilibrates") {
  int overlapping = 0;
  for (int seed = 1; seed <= 3; ++seed) {
    CAPTURE(seed);
    const Config config = benzene("0.876 g/cm3", "0.8 nm", seed);
    System system = build_system(config);
    if (overlaps(system)) ++overlapping;
    CHECK(separate_molecules(system) > 0);
    CHECK(!overlaps(system));
    CHECK(separate_molecules(system) == 0);  // it stays so
    ForceField forces(system.topology, system.forces, system.state.box);
    CHECK(equilibrate(system, forces, 0.2));
    CHECK(kinetic_temperature(system) == doctest::Approx(300));
  }
  CHECK(overlapping > 0);
}

// From there on the forces would be sums in the order of another neighbour list.
TEST_CASE("an equilibration that is stopped while molecules are moved apart begins again") {
  System system = build_system(benzene("0.876 g/cm3", "0.8 nm", 1));
  const State before = system.state;
  ForceField forces(system.topology, system.forces, system.state.box);
  int steps = 0;
  std::optional<RunState> left;
  const Watch watch{.stop = [&] { return ++steps > 1; },
                    .checkpoint = [&](RunState at) { left = std::move(at); }};
  CHECK(!equilibrate(system, forces, 0.2, watch));
  REQUIRE(left);
  CHECK(*left->equilibrated == 0);
  for (std::size_t i = 0; i < before.size(); ++i) CHECK(norm(left->state.q[i] - before.q[i]) == 0);
}

TEST_CASE("a run that is interrupted while it minimises or equilibrates ends with the same bits") {
  Config config = benzene("0.876 g/cm3", "0.8 nm", 2);
  config.run.minimise = true;
  config.run.equilibrate = 0.05;
  Simulation whole(config);
  CHECK(whole.equilibrate());
  for (const int calls : {1, 5, 100, 400}) {
    CAPTURE(calls);
    Simulation parts(config);
    int asked = 0;
    const Callbacks callbacks{.stop = [&] { return ++asked == calls; }};
    if (!parts.equilibrate(callbacks)) CHECK(parts.equilibrate(callbacks));
    for (std::size_t i = 0; i < whole.state().size(); ++i) {
      CHECK(whole.state().q[i] == parts.state().q[i]);
      CHECK(whole.state().ell[i] == parts.state().ell[i]);
    }
  }
}

TEST_CASE("a lattice needs a density or a box") {
  check_error(
      [] {
        build_system(parse_config("[system]\nmolecules = [{ model = \"argon\", count = 27 }]\n",
                                  "run.toml"));
      },
      {"there is no density, box or initial configuration", "density = \"1 g/cm3\"",
       "run.toml, system"});
}

TEST_CASE("a liquid stays as it is") {
  System water = build_system(default_config());
  const State before = water.state;
  CHECK(separate_molecules(water) == 0);
  for (std::size_t i = 0; i < before.size(); ++i) CHECK(norm(water.state.q[i] - before.q[i]) == 0);
}

TEST_CASE("at several times the density of the liquid the error names two molecules") {
  System system = build_system(benzene("4 g/cm3", "0.5 nm", 1));
  try {
    separate_molecules(system);
    FAIL("no error");
  } catch (const RunError& e) {
    const std::string text = e.what();
    for (const char* part : {"still overlap", "(benzene)", "nm apart", "use a lower density"})
      CHECK(text.find(part) != std::string::npos);
  }
}

TEST_CASE("the strongest contact names molecules, kinds, sites and their distance") {
  const Config config = parse_config(R"([system]
molecules = [{ model = "argon", count = 20 }, { model = "co2", count = 10 }]
density = "0.5 g/cm3"
[forces]
cutoff = "0.5 nm"
)",
                                     "run.toml");
  System system = build_system(config);
  const Vec3<double> carbon = system.state.q[25];
  const Vec3<double> box = system.state.box.edge;
  system.state.q.set(7, carbon + Vec3<double>{0, 0, box.z});  // of another image, and
  system.state.orientation.set(25, {1, 0, 0, 0});             // the axis is along x
  system.state.q.add(7, {0.03, 0.04, 0});
  const std::string text = strongest_contact(system, system.state);
  CAPTURE(text);
  CHECK(text.find("8 (argon)") != std::string::npos);
  CHECK(text.find("26 (co2)") != std::string::npos);
  CHECK(text.find("0.0500 nm apart") != std::string::npos);
  system.state.q.set(7, {std::nan(""), 0, 0});
  CHECK(strongest_contact(system, system.state).empty());
  CHECK(strongest_contact(system, State(0, system.state.box)).empty());  // before the first step
}
