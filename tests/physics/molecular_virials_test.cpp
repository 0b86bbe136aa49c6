// SPDX-License-Identifier: MIT
// The virials of molecules: against the virial of all, against the force of a pair, and with any
// split of the electrostatics.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "instruction_sets.hpp"
#include "physics/force_laws.hpp"
#include "polhode/forces/force_field.hpp"
#include "polhode/forces/molecular_virials.hpp"
#include "unit/errors.hpp"

using namespace polhode;

namespace {

Vec3<double> sum_of(const Vec3Column& virials) {
  Vec3<double> sum{};
  for (std::size_t i = 0; i < virials.size(); ++i) sum += virials[i];
  return sum;
}

Vec3<double> diagonal(const Mat3<double>& W) { return {W[0].x, W[1].y, W[2].z}; }

scenes::Scene fluid_of(const std::string& name, std::size_t count) {
  return scenes::spread({{{read_molecule(name), count}}}, {2, 2.1, 2.2}, 5);
}

/// The virials of the molecules, and the virial of all by the force field.
struct Virials {
  Vec3Column each;
  Vec3<double> all;
  ConstantTerms constant;
};
Virials virials_of(const scenes::Scene& scene, const ForceSettings& settings) {
  ForceField forces(scene.topology, settings, scene.state.box);
  Load load(scene.state.size());
  forces(scene.state, load);
  MolecularVirials virials(scene.topology, forces.settings(), scene.state.box);
  return {virials(scene.state), diagonal(load.virial), forces.constant_terms()};
}

}  // namespace

// The sums are the same in another order, so they agree to rounding.
TEST_CASE("virials of molecules: their sum is the virial of all") {
  for (const std::string name : {"argon", "spce", "tip4p", "co2", "benzene"})
    for (NamedLaw law : all_laws())
      for (const bool tail : {false, true}) {
        CAPTURE(name);
        CAPTURE(law.name);
        CAPTURE(tail);
        if (tail && law.settings.truncation == Truncation::site_shift) continue;  // it has no tail
        law.settings.dispersion_correction = tail;
        const Virials found = virials_of(fluid_of(name, 60), law.settings);
        double size = 0;
        for (std::size_t i = 0; i < found.each.size(); ++i) size += norm(found.each[i]);
        CHECK(norm(sum_of(found.each) - found.all) < 1e-12 * size);
      }
}

// Both meshes have double precision, so only the order of the sums differs. Sums over the grid have
// tens of thousands of terms with errors of 1e-16, up to a thousand times larger than their sum.
TEST_CASE("virials of molecules: with a mesh, and in a slab") {
  for (const std::string name : {"spce", "tip4p", "co2"})
    for (const bool slab : {false, true}) {
      CAPTURE(name);
      CAPTURE(slab);
      scenes::Scene scene = fluid_of(name, 60);
      ForceSettings settings{
          .truncation = Truncation::site_switch, .cutoff = 0.75, .switch_from = 0.6};
      settings.electrostatics = Electrostatics::pme;
      settings.slab_dispersion = slab;
      if (slab) scene.state.box.edge.z = 5;
      const Virials found = virials_of(scene, settings);
      CHECK(norm(sum_of(found.each) - found.all) < 1e-9 * norm(found.all));
    }
}

// Two molecules alone have equal virials, half of R F. Their forces by the force field give F.
TEST_CASE("virials of molecules: two of them share the virial of their pair") {
  for (const NamedLaw& law : all_laws()) {
    CAPTURE(law.name);
    scenes::Scene scene = scenes::lattice({{"tip4p", 2}}, 0.34, 6, 7);
    ForceField forces(scene.topology, law.settings, scene.state.box);
    Load load(2);
    forces(scene.state, load);
    const Vec3<double> R = scene.state.box.minimum_image(scene.state.q[1] - scene.state.q[0]);
    const Virials found = virials_of(scene, law.settings);
    const Vec3<double> expected = 0.5 * scaled(R, load.f[1]);
    REQUIRE(norm(expected) > 0.1);
    for (std::size_t i = 0; i < 2; ++i)
      CHECK(norm(found.each[i] - expected) < 1e-12 * norm(expected));
  }
}

// Ions have no arms, so the virial of each one is the same for any split of 1/r between pairs and
// mesh. Both meshes have errors of a fraction 1e-5 of the forces. Virials multiply forces by
// distances of up to 1 nm, three times the distance of neighbours.
TEST_CASE("virials of molecules: with any split of the electrostatics") {
  const scenes::Scene scene = fluid_of("na-spce", 40);
  ForceSettings settings{.truncation = Truncation::site_switch, .cutoff = 0.8, .switch_from = 0.7};
  settings.electrostatics = Electrostatics::pme;
  std::vector<Vec3Column> found;
  for (const double cutoff : {0.7, 0.85}) {
    settings.mesh = mesh_for(1e-5, cutoff, scene.state.box, scene.topology);
    found.push_back(MolecularVirials(scene.topology, settings, scene.state.box)(scene.state));
  }
  for (std::size_t i = 0; i < scene.state.size(); ++i)
    CHECK(norm(found[0][i] - found[1][i]) < 1e-4 * largest(found[0]));
}

// A virial is a sum of about 100 pairs, whose terms may be a hundred times larger.
TEST_CASE("virials of molecules: the same by all instruction sets") {
  const scenes::Scene scene = fluid_of("tip4p", 100);
  const ForceSettings settings{
      .truncation = Truncation::molecule_switch, .cutoff = 0.8, .switch_from = 0.7};
  std::vector<Vec3Column> found;
  for_each_instruction_set([&] { found.push_back(virials_of(scene, settings).each); });
  for (const Vec3Column& other : found)
    for (std::size_t i = 0; i < other.size(); ++i)
      CHECK(norm(other[i] - found[0][i]) < 1e-11 * largest(found[0]));
}

TEST_CASE("virials of molecules: what they are not defined for is an error") {
  const scenes::Scene scene = mixture();
  check_error([&] { MolecularVirials(scene.topology, {}, scene.state.box); },
              {"the virial of each molecule", "one kind of molecule"});
  const Topology water{{{read_molecule("spce"), 10}}};
  ForceSettings settings;
  settings.electrostatics = Electrostatics::pme;
  check_error([&] { MolecularVirials(water, settings, scene.state.box); },
              {"the mesh of PME", "ForceField"});
  MolecularVirials virials(water, {}, Box{Vec3<double>{3, 3, 3}});
  check_error([&] { virials(State(10, Box{Vec3<double>{4, 4, 4}})); }, {"another box"});
}
