// SPDX-License-Identifier: MIT
// Bodies reconstructed from the files of peers/.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "polhode/base/units.hpp"
#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace peers {

using namespace polhode;
using nlohmann::json;

inline Vec3<double> vec3(const json& j) { return {j[0], j[1], j[2]}; }

inline double largest(const Vec3<double>& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

inline Molecule molecule(const json& model) {
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

/// Right-handed axes: the first along a, the second towards b, arbitrary if b is parallel to a.
inline Mat3<double> axes(const Vec3<double>& a, const Vec3<double>& b) {
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
inline Quaternion<double> quaternion(const Mat3<double>& A) {
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

/// The orientation that carries the body-frame arms to the lab-frame ones.
inline Quaternion<double> orientation(const std::vector<Site>& sites,
                                      const std::vector<Vec3<double>>& arms) {
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

/// The bodies reconstructed from the site coordinates of a file.
inline Scene rebuild(const json& file, const Box& box) {
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
      const Quaternion<double> turn = orientation(sites, arms);
      scene.state.q.set(i, centre);
      scene.state.orientation.set(i, turn);
      for (std::size_t k = 0; k < sites.size(); ++k)
        off = std::max(off, largest(to_lab(turn, sites[k].r) - arms[k]));
    }
  REQUIRE(row == file["sites"].size());
  REQUIRE(off < 3e-15);  // rigid, and equal to the models: a few roundings of 2.5 nm
  return scene;
}

inline json read(const std::string& name) {
  std::ifstream in(std::string(POLHODE_TEST_DATA) + "/peers/" + name + ".json");
  REQUIRE(in);
  json file = json::parse(in);
  REQUIRE(file["coulomb"].get<double>() == doctest::Approx(units::coulomb).epsilon(1e-15));
  return file;
}

}  // namespace peers
