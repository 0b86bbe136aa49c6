// SPDX-License-Identifier: MIT
// All laws of forces, a crowd that feels all of them, and distances between forces.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "polhode/forces/reference.hpp"
#include "scenes.hpp"

namespace polhode {

struct NamedLaw {
  std::string name;
  ForceSettings settings;
};

/// Every truncation with every class of its switch and every kind of electrostatics.
inline std::vector<NamedLaw> all_laws() {
  std::vector<NamedLaw> laws;
  using enum Truncation;
  using enum Electrostatics;
  const std::string names[] = {"molecule switch", "site switch", "site shift"};
  for (const Truncation truncation : {molecule_switch, site_switch, site_shift})
    for (const int smoothness : {1, 2, 3}) {
      if (truncation == site_shift && smoothness > 1) continue;  // it has none
      const auto add = [&](Electrostatics electrostatics, double dielectric, const char* what) {
        laws.push_back({names[int(truncation)] + " " + std::to_string(smoothness) + ", " + what,
                        {truncation, 0.75, 0.55, smoothness, electrostatics, dielectric, 0.1}});
      };
      add(coulomb, 1, "Coulomb");
      add(reaction_field, 78.5, "reaction field of 78.5");
      add(reaction_field, INFINITY, "reaction field of infinity");
    }
  return laws;
}

/// All kinds of bodies at once: atoms, linear, symmetric, spherical, asymmetric.
inline scenes::Scene mixture() {
  return scenes::lattice(
      {{"argon", 3}, {"co2", 3}, {"n2", 2}, {"benzene", 2}, {"ch4", 3}, {"tip4p", 5}}, 0.62, 1.9,
      11);
}

inline Load load_of(const Topology& topology, const ForceSettings& settings, const State& state) {
  ForceField forces(topology, settings, state.box);
  Load load;
  forces(state, load);
  return load;
}

inline double largest(const Vec3Column& v) {
  double m = 0;
  for (std::size_t i = 0; i < v.size(); ++i) m = std::max(m, norm(v[i]));
  return m;
}
inline double largest_difference(const Vec3Column& a, const std::vector<Vec3<double>>& b) {
  double m = 0;
  for (std::size_t i = 0; i < a.size(); ++i) m = std::max(m, norm(a[i] - b[i]));
  return m;
}
inline double largest(const Mat3<double>& m) {
  double most = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) most = std::max(most, std::abs(m[i][k]));
  return most;
}
inline double largest_difference(const Mat3<double>& a, const Mat3<double>& b) {
  double most = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) most = std::max(most, std::abs(a[i][k] - b[i][k]));
  return most;
}

}  // namespace polhode
