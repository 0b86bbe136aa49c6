// SPDX-License-Identifier: MIT
// The box belongs to the state: when it changes between two evaluations, every result of a force
// field is that of one constructed for the new box, to the last bit.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "physics/load_bits.hpp"
#include "physics/mesh_scene.hpp"
#include "polhode/base/workers.hpp"
#include "polhode/run/simulation/system/system.hpp"
#include "unit/errors.hpp"

using namespace polhode;

namespace {

using Bits = std::vector<std::uint64_t>;

/// Water, linear molecules, atoms and ions with a net charge; 300 bodies, so that the list has
/// several chunks.
scenes::Scene solution() {
  return scenes::spread({{{read_molecule("tip4p"), 240},
                          {ion("anion", -1), 12},
                          {read_molecule("co2"), 24},
                          {read_molecule("argon"), 12},
                          {ion("cation", 2), 12}}},
                        {2.3, 2.5, 2.4}, 23);
}

/// Every cutoff treatment; with PME, a mesh that is chosen for each box, and one that is given.
std::vector<NamedLaw> laws() {
  using enum Truncation;
  using enum Electrostatics;
  const auto settings = [](Truncation truncation, Electrostatics electrostatics) {
    return ForceSettings{.truncation = truncation,
                         .cutoff = 0.7,
                         .switch_from = 0.6,
                         .electrostatics = electrostatics,
                         .dispersion_correction = truncation != site_shift};
  };
  ForceSettings given = settings(site_switch, pme);
  given.mesh = MeshSettings{.points = {20, 24, 16}, .order = 5, .exponent = 5, .cutoff = 0.7};
  return {{"molecule switch", settings(molecule_switch, reaction_field)},
          {"site switch", settings(site_switch, reaction_field)},
          {"site shift", settings(site_shift, reaction_field)},
          {"damped shifted force", settings(site_switch, damped_shifted_force)},
          {"PME", settings(site_switch, pme)},
          {"PME, mesh given", given}};
}

/// The state in another box, with its centres scaled likewise.
State scaled_by(const State& state, const Vec3<double>& factor) {
  State other = state;
  other.box.edge = scaled(factor, state.box.edge);
  for (std::size_t i = 0; i < state.size(); ++i) other.q.set(i, scaled(factor, state.q[i]));
  return other;
}

struct NamedState {
  std::string name;
  State state;
};

/// Volumes 30 % larger and smaller, by all edges and by one alone; edges that grow while the
/// centres stay where they are, by so little that even their order in the list is the same, and by
/// much; then the first state again.
std::vector<NamedState> states(const State& first) {
  const double up = std::cbrt(1.3), down = std::cbrt(0.7);
  State wider = first;
  for (std::size_t i = 0; i < first.size(); ++i)  // into the box, so that no centre is wrapped
    wider.q.set(i, 0.98 * first.q[i] + Vec3<double>{0.02, 0.02, 0.02});
  State little = wider, much = wider;
  little.box.edge.x *= 1 + 1e-6;
  much.box.edge.x *= 1.3;
  return {{"first", first},
          {"all edges up", scaled_by(first, {up, up, up})},
          {"all edges down", scaled_by(first, {down, down, down})},
          {"x up", scaled_by(first, {1.3, 1, 1})},
          {"y down", scaled_by(first, {1, 0.7, 1})},
          {"z down", scaled_by(first, {1, 1, 0.7})},
          {"moved", wider},
          {"x up a little, centres as they were", little},
          {"x up, centres as they were", much},
          {"first again", first}};
}

/// One of the three kinds of evaluation: forces with energies, forces alone, derivative.
Bits result(ForceField& forces, const State& state, int kind) {
  Load load;
  if (kind == 0) forces(state, load);
  if (kind == 1) forces.forces_alone(state, load);
  if (kind == 2) {
    Vec3Column dq(state.size()), dtheta(state.size());
    for (std::size_t i = 0; i < state.size(); ++i) {
      const double x = static_cast<double>(i);
      dq.set(i, {std::sin(x), std::cos(3 * x), std::sin(5 * x)});
      dtheta.set(i, {std::cos(x), std::sin(2 * x), std::cos(7 * x)});
    }
    forces.directional_derivative(state, dq, dtheta, load);
  }
  return bits(load);
}

/// Takes a force field through all states; in each, `first_kind` is evaluated before the others.
void check_follows(const scenes::Scene& scene, const ForceSettings& settings, int first_kind,
                   Workers& workers) {
  ForceField forces(scene.topology, settings, scene.state.box, workers);
  for (const auto& [name, state] : states(scene.state)) {
    const auto shown_name = name;
    CAPTURE(shown_name);
    ForceField fresh(scene.topology, settings, state.box);
    for (int n = 0; n < 3; ++n) {
      const int kind = (first_kind + n) % 3;
      CAPTURE(kind);
      CHECK((result(forces, state, kind) == result(fresh, state, kind)));
    }
    CHECK(forces.settings().mesh == fresh.settings().mesh);
    CHECK(forces.constant_terms().coulomb() == fresh.constant_terms().coulomb());
    CHECK(forces.constant_terms().dispersion == fresh.constant_terms().dispersion);
  }
}

}  // namespace

TEST_CASE("results follow the box of the state, to the last bit") {
  const scenes::Scene scene = solution();
  for (const NamedLaw& law : laws())
    for (const Precision precision : {Precision::double_precision, Precision::mixed})
      for (const int threads : {1, 2}) {
        CAPTURE(law.name);
        CAPTURE(int(precision));
        CAPTURE(threads);
        ForceSettings settings = law.settings;
        settings.precision = precision;
        Workers workers(threads);
        const int first_kind = threads == 1 ? 0 : 2;
        check_follows(scene, settings, first_kind, workers);
      }
}

// With several threads the mesh knows which planes a body can touch: more, the closer they are.
TEST_CASE("long molecules keep their charges on the mesh when the box shrinks") {
  const Molecule rod =
      rigid_molecule("rod", {{.name = "A", .r = {0, 0, 0.6}, .mass = 10, .charge = 1},
                             {.name = "B", .r = {0, 0, -0.6}, .mass = 10, .charge = -1}});
  const scenes::Scene scene = scenes::spread({{{rod, 1}}}, {2.5, 2.5, 10}, 5);
  ForceSettings settings = laws().back().settings;
  settings.dispersion_correction = false;
  settings.mesh->points = {24, 24, 32};
  settings.mesh->order = 4;
  const State flat = scaled_by(scene.state, {1, 1, 0.25});
  Workers workers(2);
  ForceField forces(scene.topology, settings, scene.state.box, workers);
  ForceField fresh(scene.topology, settings, flat.box);
  for (const int kind : {0, 1, 2}) {
    result(forces, scene.state, kind);
    CHECK((result(forces, flat, kind) == result(fresh, flat, kind)));
  }
}

TEST_CASE("nothing is built again while the box stays") {
  const scenes::Scene scene = solution();
  for (const NamedLaw& law : laws()) {
    CAPTURE(law.name);
    ForceField forces(scene.topology, law.settings, scene.state.box);
    Load load;
    for (int n = 0; n < 3; ++n) forces(scene.state, load);
    CHECK(forces.list_rebuilds() == 1);
    forces(scaled_by(scene.state, {1, 1, 1.01}), load);
    CHECK(forces.list_rebuilds() == 2);
  }
}

TEST_CASE(
    "a box that does not fit throws the error of the constructor, and the next one is served") {
  const scenes::Scene scene = solution();
  for (const NamedLaw& law : laws())
    for (const Vec3<double>& factor :
         {Vec3<double>{0.5, 0.5, 0.5}, {1, 1, 0.58}, {1, 4000, 1}, {1, NAN, 1}, {1, 1, 0}}) {
      CAPTURE(law.name);
      CAPTURE(factor.y);
      const State other = scaled_by(scene.state, factor);
      ForceField forces(scene.topology, law.settings, scene.state.box);
      Load load;
      forces(scene.state, load);
      std::string expected;
      try {
        ForceField(scene.topology, law.settings, other.box);
      } catch (const Error& e) {
        expected = e.what();
      }
      REQUIRE(!expected.empty());
      check_error([&] { forces(other, load); }, {expected.c_str()});
      check_error([&] { forces.forces_alone(other, load); }, {expected.c_str()});
      ForceField fresh(scene.topology, law.settings, scene.state.box);
      for (const int kind : {0, 1, 2})
        CHECK((result(forces, scene.state, kind) == result(fresh, scene.state, kind)));
    }
}

// A system of a run file carries the mesh that was chosen for its first box.
TEST_CASE("a mesh that was chosen follows the box, and one that was given stays") {
  Config config = default_config();
  config.forces.truncation = Truncation::site_switch;
  config.forces.electrostatics = Electrostatics::pme;
  const System system = build_system(config);
  REQUIRE(system.forces.mesh.has_value());
  const State larger = scaled_by(system.state, {1.5, 1.5, 1.5});
  ForceField forces(system.topology, system.forces, system.state.box);
  Load load;
  forces(larger, load);
  CHECK(forces.settings().mesh == mesh_for(config.forces, larger.box, system.topology));
  CHECK(forces.settings().mesh->points[0] > system.forces.mesh->points[0]);

  ForceSettings given = system.forces;
  given.mesh_chosen_for.reset();
  ForceField with_given(system.topology, given, system.state.box);
  with_given(larger, load);
  CHECK(with_given.settings().mesh == system.forces.mesh);
}

// The list is remembered with the box that it was built in, and not at all if the state has
// another.
TEST_CASE("forces resumed in another box than that of the constructor have the same bits") {
  const scenes::Scene scene = solution();
  const State smaller = scaled_by(scene.state, {0.9, 0.95, 0.85});
  State later = smaller;  // within the skin, so that the list is kept
  for (std::size_t i = 0; i < later.size(); ++i)
    later.q.set(i, smaller.q[i] + 0.01 * Vec3<double>{std::sin(double(i)), 0, std::cos(double(i))});
  for (const NamedLaw& law : laws()) {
    CAPTURE(law.name);
    ForceField forces(scene.topology, law.settings, scene.state.box);
    Load load;
    forces(scene.state, load);
    forces(smaller, load);
    const ListMemory memory = forces.list_memory(smaller.box);
    CHECK(memory.built_at.size() == smaller.size());
    CHECK(forces.list_memory(scene.state.box).built_at.size() == 0);

    ForceField resumed(scene.topology, law.settings, scene.state.box);
    resumed.resume_from(memory, later.box);
    CHECK((result(resumed, later, 0) == result(forces, later, 0)));
    CHECK(resumed.list_rebuilds() == 2);
    CHECK(forces.list_rebuilds() == 2);
  }
}
