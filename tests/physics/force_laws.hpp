// SPDX-License-Identifier: MIT
// All force laws, a mixture that interacts by all of them, and distances between forces.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "polhode/base/units.hpp"
#include "reference_forces.hpp"
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
      if (truncation == site_shift && smoothness > 1) continue;  // has no class
      const auto add = [&](Electrostatics electrostatics, double dielectric, const char* what) {
        laws.push_back({names[int(truncation)] + " " + std::to_string(smoothness) + ", " + what,
                        {truncation, 0.75, 0.55, smoothness, electrostatics, dielectric, 0.1}});
      };
      add(coulomb, 1, "Coulomb");
      add(reaction_field, 78.5, "reaction field of 78.5");
      add(reaction_field, INFINITY, "reaction field of infinity");
      if (truncation == site_switch) add(damped_shifted_force, 1, "damped shifted force");
    }
  return laws;
}

/// All kinds of bodies together: atoms, linear, symmetric, spherical, asymmetric.
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
  double max_size = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) max_size = std::max(max_size, std::abs(m[i][k]));
  return max_size;
}
inline double largest_difference(const Mat3<double>& a, const Mat3<double>& b) {
  double max_size = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) max_size = std::max(max_size, std::abs(a[i][k] - b[i][k]));
  return max_size;
}

inline double rms_distance(const Vec3Column& a, const std::vector<Vec3<double>>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += norm2(a[i] - b[i]);
  return std::sqrt(sum / double(a.size()));
}

/// The scale of rounding errors, from all terms of the energy.
struct Terms {
  double sum = 0;              ///< Σ |u| [kJ/mol]
  double f2 = 0, tau2 = 0;     ///< mean squares of the float errors of forces and torques
  double u2 = 0, virial2 = 0;  ///< squares of the float errors of the energy and the virial
  double f2_of_places = 0;     ///< the same for forces, from positions rounded to 2⁻²⁴ nm
};

/// Rounding to float has an rms of 0.4 × 2⁻²⁴. Three roundings make up r², to which a term u of
/// power n responds n/2 times, and about four its powers, products and the sum: together 0.7
/// √((n/2)² + 1) × 2⁻²⁴ of its force n u/r. A switch adds the force w'(r) u, a shift subtracts a
/// term of the same size again, and a reaction field adds at most (r/r_c)³ of 1/r. Rounding
/// positions by δ = 2⁻²⁴ nm changes a force by n (n + 1) u/r² δ; a site switch adds u w'' δ, where
/// w'' is at most 7.5 over the width squared. The torque on one body of a pair is computed from
/// that on the other and the moment R × f: two roundings of that, about 0.6 × 2⁻²⁴ R f.
inline Terms terms_of(const scenes::Scene& scene, const ForceSettings& settings) {
  const State& state = scene.state;
  const Switch<> w(settings.switch_from, settings.cutoff, settings.smoothness);
  const double width = settings.cutoff - settings.switch_from;
  const bool by_molecule = settings.truncation == Truncation::molecule_switch;
  const bool by_site = settings.truncation == Truncation::site_switch;
  Terms terms;
  for (std::size_t i = 0; i < state.size(); ++i)
    for (std::size_t j = i + 1; j < state.size(); ++j) {
      const Molecule& a_molecule = scene.topology.parts[scene.bodies.part[i]].molecule;
      const Molecule& b_molecule = scene.topology.parts[scene.bodies.part[j]].molecule;
      Vec3<double> R = state.q[j] - state.q[i];
      for (std::size_t d = 0; d < 3; ++d)
        R[d] -= std::round(R[d] / state.box.edge[d]) * state.box.edge[d];
      if (norm(R) > settings.cutoff + (by_molecule ? 0 : a_molecule.extent() + b_molecule.extent()))
        continue;
      for (const Site& a : a_molecule.sites)
        for (const Site& b : b_molecule.sites) {
          const double r =
              norm(R + to_lab(state.orientation[j], b.r) - to_lab(state.orientation[i], a.r));
          if (!by_molecule && r > settings.cutoff) continue;
          const double end = by_molecule ? norm(R) : by_site ? r : 0;  // argument of the switch
          const double bend = !by_site || w(end).slope == 0 ? 0 : 7.5 * end / (width * width);
          const double slope = std::abs(w(end).slope);
          const double beyond = settings.electrostatics == Electrostatics::reaction_field
                                    ? std::pow(r / settings.cutoff, 3)
                                    : 0;
          const double terms_each = by_molecule || by_site ? 1 : 2;
          const double x = std::pow((a.sigma + b.sigma) / 2 / r, 6);
          const double depth = 4 * std::sqrt(a.epsilon * b.epsilon);
          const auto add = [&](int n, double u) {
            const double f =
                0.7 * 0x1p-24 * u * (terms_each * std::hypot(n / 2.0, 1) * n / r + slope);
            const double by_place = 0x1p-24 * u * (n * (n + 1) / (r * r) + bend);
            const double du = 0x1p-24 * u * (0.7 * std::hypot(n / 2.0, 1) + n / r);
            terms.sum += u;
            terms.u2 += du * du;
            terms.virial2 += norm2(R) * (f * f + by_place * by_place);
            terms.f2 += 2 * f * f / double(state.size());  // on both bodies
            const double moment = 0.6 * 0x1p-24 * n * u / r * norm(R);
            if (a_molecule.extent() > 0 || b_molecule.extent() > 0)
              terms.tau2 +=
                  (f * f * (norm2(a.r) + norm2(b.r)) + moment * moment) / double(state.size());
            terms.f2_of_places += 2 * by_place * by_place / double(state.size());
          };
          add(1, units::coulomb * std::abs(a.charge * b.charge) / r * (1 + beyond));
          add(6, depth * x);
          add(12, depth * x * x);
        }
    }
  return terms;
}

}  // namespace polhode
