// SPDX-License-Identifier: MIT
// Energies, forces and torques against engines nobody here wrote: OpenMM and LAMMPS, in doubles.
// peers/README.md says how the numbers were made; peers/generate.py made them.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "polhode/base/target.hpp"
#include "polhode/base/units.hpp"
#include "polhode/forces/force_field.hpp"

using namespace polhode;
using nlohmann::json;

namespace {

// Where the deviations come from. The peers' own numbers are right to 3e-14 of the largest force
// and of the potential (peers/README.md). Coordinates of 2.5 nm, in the file and once more in our
// centres and arms, are rounded by up to 1e-15 nm in all; contacts in liquids have a stiffness near
// 1e5 kJ/mol/nm², so forces move by 1e-10 kJ/mol/nm where the largest are near 1000: 1e-13 of them.
// Twice that is allowed; the liquids need a quarter of it. Energies move far less, since they are
// sums over bodies with random signs; the same relative bound holds for them, in which the two
// terms count without their signs.
constexpr double tolerance = 2e-13;

Vec3<double> vec3(const json& j) { return {j[0], j[1], j[2]}; }

double largest(const Vec3<double>& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

Molecule molecule(const json& model) {
  std::vector<Site> sites;
  for (std::size_t k = 0; k < model["sites"].size(); ++k)
    sites.push_back({.name = model["sites"][k],
                     .element = "",
                     .r = vec3(model["position"][k]),
                     .mass = model["mass"][k],
                     .charge = model["charge"][k],
                     .sigma = model["sigma"][k],
                     .epsilon = model["epsilon"][k]});
  return rigid_molecule(model["name"], std::move(sites));
}

/// Right-handed axes: the first along a, the second towards b. Any second where b is parallel to a.
Mat3<double> axes(const Vec3<double>& a, const Vec3<double>& b) {
  const Vec3<double> x = a / norm(a);
  Vec3<double> y = b - dot(b, x) * x;
  if (norm(y) < 1e-8) {
    const Vec3<double> aside = std::abs(x.x) < 0.5 ? Vec3<double>{1, 0, 0} : Vec3<double>{0, 1, 0};
    y = aside - dot(aside, x) * x;
  }
  y = y / norm(y);
  return {x, y, cross(x, y)};
}

/// The unit quaternion of a rotation matrix A, body → lab.
Quaternion<double> quaternion(const Mat3<double>& A) {
  const double xx = A.row0.x, yy = A.row1.y, zz = A.row2.z;
  const double w2 = 1 + xx + yy + zz, x2 = 1 + xx - yy - zz, y2 = 1 - xx + yy - zz,
               z2 = 1 - xx - yy + zz;  // 4 times the squares; divide by the largest
  const double a = A.row2.y - A.row1.z, b = A.row0.z - A.row2.x, c = A.row1.x - A.row0.y;
  const double d = A.row0.y + A.row1.x, e = A.row1.z + A.row2.y, f = A.row2.x + A.row0.z;
  const double top = std::max({w2, x2, y2, z2});
  const Quaternion<double> q = top == w2   ? Quaternion<double>{w2, a, b, c}
                               : top == x2 ? Quaternion<double>{a, x2, d, f}
                               : top == y2 ? Quaternion<double>{b, d, y2, e}
                                           : Quaternion<double>{c, f, e, z2};
  const double length = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return {q.w / length, q.x / length, q.y / length, q.z / length};
}

/// The attitude that carries the body-frame arms to the lab-frame ones.
Quaternion<double> attitude(const std::vector<Site>& sites, const std::vector<Vec3<double>>& arms) {
  std::size_t a = 0, b = 0;  // the farthest site, and the one farthest from its axis
  for (std::size_t k = 0; k < sites.size(); ++k)
    if (norm(sites[k].r) > norm(sites[a].r)) a = k;
  if (norm(sites[a].r) == 0) return {};
  for (std::size_t k = 0; k < sites.size(); ++k)
    if (norm(cross(sites[k].r, sites[a].r)) > norm(cross(sites[b].r, sites[a].r))) b = k;
  return quaternion(transpose(axes(arms[a], arms[b])) * axes(sites[a].r, sites[b].r));
}

struct Scene {
  Topology topology;
  State state;
};

/// The bodies that the file's site coordinates make.
Scene rebuild(const json& file, const Box& box) {
  Scene scene;
  for (std::size_t k = 0; k < file["bodies"].size(); ++k)
    scene.topology.parts.push_back({molecule(file["models"][k]), file["bodies"][k]["count"]});
  scene.state = State(scene.topology.size(), box);
  std::size_t i = 0, row = 0;
  double off = 0;
  for (const auto& part : scene.topology.parts)
    for (std::size_t n = 0; n < part.count; ++n, ++i) {
      const auto& sites = part.molecule.sites;
      std::vector<Vec3<double>> arms;
      Vec3<double> centre{};
      for (const Site& site : sites) {
        arms.push_back(vec3(file["sites"][row++]));
        centre += site.mass * arms.back();
      }
      centre = centre / part.molecule.mass;
      for (auto& arm : arms) arm -= centre;
      const Quaternion<double> turn = attitude(sites, arms);
      scene.state.q.set(i, centre);
      scene.state.attitude.set(i, turn);
      for (std::size_t k = 0; k < sites.size(); ++k)
        off = std::max(off, largest(to_lab(turn, sites[k].r) - arms[k]));
    }
  REQUIRE(row == file["sites"].size());
  REQUIRE(off < 3e-15);  // rigid, and the models' own: some roundings of 2.5 nm
  return scene;
}

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
  const Target usual = current_target();
  for (const Target target : available_targets()) {
    force_target(target);
    ForceField forces(scene.topology, law, scene.state.box);
    Load load(scene.state.size());
    forces(scene.state, load);

    double force = 0, torque = 0;
    for (std::size_t i = 0; i < scene.state.size(); ++i) {
      force = std::max(force, largest(load.f[i] - vec3(result["force"][i])));
      torque = std::max(torque, largest(load.tau[i] - vec3(result["torque"][i])));
    }
    const json& energy = result["energy"];
    const double lennard_jones = energy["lennard_jones"], coulomb = energy["coulomb"];
    const double scale = std::abs(lennard_jones) + std::abs(coulomb);

    INFO(result["engine"].get<std::string>(), ", ", result["law"].dump(), ", ",
         std::string(name(target)));
    CHECK(force <= tolerance * result["largest"]["force"].get<double>());
    CHECK(torque <= tolerance * result["largest"]["torque"].get<double>());
    CHECK(std::abs(load.lennard_jones - lennard_jones) <= tolerance * scale);
    CHECK(std::abs(load.coulomb - coulomb) <= tolerance * scale);
    CHECK(std::abs(load.potential() - energy["potential"].get<double>()) <= tolerance * scale);
  }
  force_target(usual);
}

json read(const std::string& name) {
  std::ifstream in(std::string(POLHODE_TEST_DATA) + "/peers/" + name + ".json");
  REQUIRE(in);
  json file = json::parse(in);
  REQUIRE(file["coulomb"].get<double>() == doctest::Approx(units::coulomb).epsilon(1e-15));
  return file;
}

void periodic(const std::string& name) {
  const json file = read(name);
  const Scene scene = rebuild(file, {vec3(file["box"])});
  for (const json& result : file["results"]) compare(scene, settings(result["law"]), result);
}

// A cluster in open space: both laws become plain Lennard-Jones and Coulomb within a cutoff that
// nothing reaches; the reaction field's constant c adds nothing between neutral molecules.
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

TEST_CASE("Forces equal OpenMM's and LAMMPS's: 216 TIP4P") { periodic("tip4p-216"); }
TEST_CASE("Forces equal OpenMM's and LAMMPS's: SPC/E, nitrogen, carbon dioxide and argon") {
  periodic("spce-n2-co2-argon");
}
TEST_CASE("Forces equal OpenMM's and LAMMPS's: benzene and methane") { periodic("benzene-ch4"); }
TEST_CASE("Forces equal OpenMM's and LAMMPS's: TIP3P and TIP4P/2005, switches C1 and C3") {
  periodic("tip3p-tip4p2005");
}
TEST_CASE("Forces equal OpenMM's and LAMMPS's: 512 TIP4P") { periodic("w512"); }
TEST_CASE("Forces equal OpenMM's and LAMMPS's: TIP4P cluster in open space") {
  open("tip4p-cluster");
}
TEST_CASE("Forces equal OpenMM's and LAMMPS's: mixed cluster in open space") {
  open("mixed-cluster");
}
