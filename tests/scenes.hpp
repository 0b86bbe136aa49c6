// SPDX-License-Identifier: MIT
// Small systems shared by the tests.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "polhode/base/units.hpp"
#include "polhode/forces/force_field.hpp"
#include "polhode/io/topology/molecule_file.hpp"
#include "reference_forces.hpp"

namespace polhode::scenes {

/// A usual temperature [K], with its kT [kJ/mol].
inline constexpr double kelvin = 300, kT = units::boltzmann * kelvin;

struct Scene {
  Topology topology;
  Bodies bodies;
  State state;
};

inline Quaternion<double> random_orientation(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const double w = normal(random), x = normal(random), y = normal(random), z = normal(random);
  return normalized(Quaternion<double>{w, x, y, z});
}

/// Molecules at some of the given positions, in random order, displaced by about `jitter` [nm],
/// with thermal-like momenta from a fixed seed.
inline Scene populated(const Topology& topology, const Vec3<double>& box,
                       std::vector<Vec3<double>> places, double jitter, unsigned seed) {
  Scene scene{topology, Bodies(topology), State(topology.size(), Box{box})};
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  const auto vector = [&](double scale) {
    const double x = normal(random), y = normal(random), z = normal(random);
    return scale * Vec3<double>{x, y, z};
  };
  std::shuffle(places.begin(), places.end(), random);
  for (std::size_t i = 0; i < topology.size(); ++i) {
    scene.state.q.set(i, places[i] + vector(jitter));
    scene.state.p.set(i, vector(std::sqrt(2.5 * scene.bodies.m[i])));  // kT of 300 K
    scene.state.orientation.set(i, random_orientation(random));
    const Vec3<double> J = scene.bodies.J[i];
    const Vec3<double> L =
        scaled(vector(std::sqrt(2.5)), {std::sqrt(J.x), std::sqrt(J.y), std::sqrt(J.z)});
    scene.state.ell.set(i, to_lab(scene.state.orientation[i], L));
  }
  return scene;
}

/// Molecules by name on a jittered cubic lattice of spacing `a` [nm] in the given box.
inline Scene lattice(const std::vector<std::pair<std::string, std::size_t>>& parts, double a,
                     double box, unsigned seed) {
  Topology topology;
  for (const auto& [name, count] : parts) topology.parts.push_back({read_molecule(name), count});
  std::size_t n = 1;
  while (n * n * n < topology.size()) ++n;
  std::vector<Vec3<double>> places;
  for (std::size_t k = 0; k < n * n * n; ++k)
    places.push_back(a * Vec3<double>{double(k % n), double(k / n % n), double(k / (n * n))});
  return populated(topology, {box, box, box}, places, 0.01 * a, seed);
}

/// Molecules spread evenly over a box of any edges.
inline Scene spread(const Topology& topology, const Vec3<double>& box, unsigned seed) {
  double a = std::cbrt(box.x * box.y * box.z / double(topology.size()));
  const auto along = [&](double edge) { return std::max<std::size_t>(1, std::size_t(edge / a)); };
  while (along(box.x) * along(box.y) * along(box.z) < topology.size()) a *= 0.99;
  const std::size_t nx = along(box.x), ny = along(box.y), nz = along(box.z);
  std::vector<Vec3<double>> places;
  for (std::size_t k = 0; k < nx * ny * nz; ++k)
    places.push_back(
        scaled(Vec3<double>{double(k % nx) / double(nx), double(k / nx % ny) / double(ny),
                            double(k / (nx * ny)) / double(nz)},
               box));
  return populated(topology, box, places, 0.01 * a, seed);
}

/// Five waters close together in vacuum, well inside the switching distance.
inline Scene water_cluster() { return lattice({{"tip4p", 5}}, 0.32, 40, 7); }
inline ForceSettings no_truncation() { return {.cutoff = 19, .switch_from = 18}; }

inline std::vector<Pose<double>> poses(const State& state) {
  std::vector<Pose<double>> all;
  for (std::size_t i = 0; i < state.size(); ++i) all.push_back({state.q[i], state.orientation[i]});
  return all;
}

/// Forces of free bodies.
inline void no_forces(const State&, Load& load) { load = Load(load.f.size()); }

}  // namespace polhode::scenes

namespace polhode {

/// The largest length of the difference of two vectors with the same index.
inline double largest_difference(const Vec3Column& a, const Vec3Column& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, norm(a[i] - b[i]));
  return largest;
}

}  // namespace polhode
