// SPDX-License-Identifier: MIT
// Energies, forces and torques compared with independent engines, OpenMM and LAMMPS, in double.
// peers/README.md describes the reference values; peers/generate.py made them.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "base/instruction_set.hpp"
#include "polhode/forces/force_field.hpp"
#include "reference/peers_scene.hpp"

using namespace polhode;
using namespace peers;

namespace {

// Sources of the deviations: the reference values are accurate to 3e-14 of the largest force
// and of the potential (peers/README.md). Coordinates of 2.5 nm, in the file and again in our
// centres and arms, are rounded by up to 1e-15 nm in total; contacts in liquids have a stiffness of
// about 1e5 kJ/mol/nm², so forces change by 1e-10 kJ/mol/nm where the largest are near 1000: a
// relative 1e-13. Twice that is allowed; the liquids need a quarter of it. Energies change far
// less, because they are sums over bodies with random signs; the same relative bound is used for
// them, with respect to the sum of the absolute values of both terms.
constexpr double tolerance = 2e-13;

ForceSettings settings(const json& law) {
  ForceSettings s;
  s.truncation =
      law["truncation"] == "reaction_field" ? Truncation::site_switch : Truncation::molecule_switch;
  s.electrostatics = law["truncation"] == "reaction_field" ? Electrostatics::reaction_field
                                                           : Electrostatics::coulomb;
  s.switch_from = law["switch_from"];
  s.cutoff = law["cutoff"];
  s.smoothness = law["smoothness"];
  if (law.contains("dielectric"))
    s.dielectric = law["dielectric"].is_string() ? std::numeric_limits<double>::infinity()
                                                 : law["dielectric"].get<double>();
  return s;
}

void compare(const Scene& scene, const ForceSettings& law, const json& result) {
  const InstructionSet usual = current_instruction_set();
  for (const InstructionSet instruction_set : available_instruction_sets()) {
    force_instruction_set(instruction_set);
    ForceField forces(scene.topology, law, scene.state.box);
    Load load(scene.state.size());
    forces(scene.state, load);

    double force = 0, torque = 0;
    for (std::size_t i = 0; i < scene.state.size(); ++i) {
      force = std::max(force, largest(load.f[i] - vec3(result["force"][i])));
      torque = std::max(torque, largest(load.tau[i] - vec3(result["torque"][i])));
    }
    const json& energy = result["energy"];
    const double van_der_waals = energy["lennard_jones"], coulomb = energy["coulomb"];
    const double scale = std::abs(van_der_waals) + std::abs(coulomb);

    INFO(result["engine"].get<std::string>(), ", ", result["law"].dump(), ", ",
         std::string(name(instruction_set)));
    CHECK(force <= tolerance * result["largest"]["force"].get<double>());
    CHECK(torque <= tolerance * result["largest"]["torque"].get<double>());
    CHECK(std::abs(load.van_der_waals - van_der_waals) <= tolerance * scale);
    CHECK(std::abs(load.coulomb - coulomb) <= tolerance * scale);
    CHECK(std::abs(load.potential() - energy["potential"].get<double>()) <= tolerance * scale);
  }
  force_instruction_set(usual);
}

void periodic(const std::string& name) {
  const json file = read(name);
  const Scene scene = rebuild(file, {vec3(file["box"])});
  for (const json& result : file["results"]) compare(scene, settings(result["law"]), result);
}

// A cluster in open space: both interactions become plain Lennard-Jones and Coulomb with a cutoff
// larger than the cluster; the constant c of the reaction field cancels between neutral molecules.
void open(const std::string& name) {
  const json file = read(name);
  const Scene scene = rebuild(file, {{8, 8, 8}});
  for (const json& result : file["results"])
    for (const Truncation truncation : {Truncation::molecule_switch, Truncation::site_switch}) {
      ForceSettings law;
      law.truncation = truncation;
      law.electrostatics = truncation == Truncation::site_switch ? Electrostatics::reaction_field
                                                                 : Electrostatics::coulomb;
      law.switch_from = 3.5;
      law.cutoff = 4;
      law.dielectric = 1;
      compare(scene, law, result);
    }
}

}  // namespace

TEST_CASE("forces equal those of OpenMM and LAMMPS: 216 TIP4P") { periodic("tip4p-216"); }
TEST_CASE("forces equal those of OpenMM and LAMMPS: SPC/E, nitrogen, carbon dioxide and argon") {
  periodic("spce-n2-co2-argon");
}
TEST_CASE("forces equal those of OpenMM and LAMMPS: benzene and methane") {
  periodic("benzene-ch4");
}
TEST_CASE("forces equal those of OpenMM and LAMMPS: TIP3P and TIP4P/2005, switches C1 and C3") {
  periodic("tip3p-tip4p2005");
}
TEST_CASE("forces equal those of OpenMM and LAMMPS: 512 TIP4P") { periodic("w512"); }
TEST_CASE("forces equal those of OpenMM and LAMMPS: TIP4P cluster in open space") {
  open("tip4p-cluster");
}
TEST_CASE("forces equal those of OpenMM and LAMMPS: mixed cluster in open space") {
  open("mixed-cluster");
}
