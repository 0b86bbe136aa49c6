// SPDX-License-Identifier: MIT
// Small systems that the tests share.
#pragma once

#include <random>
#include <string>
#include <utility>
#include <vector>

#include "polhode/forces/force_field.hpp"
#include "polhode/forces/reference.hpp"
#include "polhode/io/molecule_file.hpp"

namespace polhode::scenes {

struct Scene {
  Topology topology;
  Bodies bodies;
  State state;
};

inline Quaternion<double> random_attitude(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const double w = normal(random), x = normal(random), y = normal(random), z = normal(random);
  return normalized(Quaternion<double>{w, x, y, z});
}

/// Molecules on a jittered cubic lattice of spacing `a` [nm] in the given box, with thermal-like
/// momenta from a fixed seed.
inline Scene lattice(const std::vector<std::pair<std::string, std::size_t>>& parts, double a,
                     double box, unsigned seed) {
  Topology topology;
  for (const auto& [name, count] : parts) topology.parts.push_back({read_molecule(name), count});
  Scene scene{topology, Bodies(topology), State(topology.size(), Box{{box, box, box}})};
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  const auto vector = [&](double scale) {
    const double x = normal(random), y = normal(random), z = normal(random);
    return scale * Vec3<double>{x, y, z};
  };
  std::size_t n = 1;
  while (n * n * n < topology.size()) ++n;
  std::vector<std::size_t> places(n * n * n);
  for (std::size_t i = 0; i < places.size(); ++i) places[i] = i;
  std::shuffle(places.begin(), places.end(), random);
  for (std::size_t i = 0; i < topology.size(); ++i) {
    const std::size_t k = places[i];
    const Vec3<double> place{double(k % n), double(k / n % n), double(k / (n * n))};
    scene.state.q.set(i, a * place + vector(0.01 * a));
    scene.state.p.set(i, vector(std::sqrt(2.5 * scene.bodies.m[i])));  // kT of 300 K
    scene.state.attitude.set(i, random_attitude(random));
    const Vec3<double> J = scene.bodies.J[i];
    const Vec3<double> L =
        scaled(vector(std::sqrt(2.5)), {std::sqrt(J.x), std::sqrt(J.y), std::sqrt(J.z)});
    scene.state.ell.set(i, to_lab(scene.state.attitude[i], L));
  }
  return scene;
}

/// Five waters close together in vacuum: the switch begins far beyond them.
inline Scene water_cluster() { return lattice({{"tip4p", 5}}, 0.32, 40, 7); }
inline ForceSettings no_truncation() { return {.cutoff = 19, .switch_from = 18}; }

inline std::vector<Pose<double>> poses(const State& state) {
  std::vector<Pose<double>> all;
  for (std::size_t i = 0; i < state.size(); ++i) all.push_back({state.q[i], state.attitude[i]});
  return all;
}

}  // namespace polhode::scenes
