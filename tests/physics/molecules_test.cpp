// SPDX-License-Identifier: MIT
// Laws that hold for every built-in molecule model.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "physics/force_laws.hpp"
#include "polhode/integrate/integrator.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/io/topology/molecule_file.hpp"
#include "polhode/math/rotation.hpp"
#include "polhode/measure/energy.hpp"
#include "polhode/run/simulation/system/system.hpp"

using namespace polhode;

namespace {

struct Crowd {
  scenes::Scene scene;
  ForceSettings forces;
};

// Where the law of a site becomes repulsive [nm]; 0 if it has none.
double diameter(const Site& site) {
  const ShortRange<double> law = short_range(site.sigma, site.epsilon, site.law);
  if (!site.has_short_range() || law.is_lennard_jones()) return site.sigma;
  double r = 1;
  while (law(InversePowers<double>(r * r), r * r).u < 0) r -= 0.001;
  return r;
}

// 27 bodies in a periodic box, with pairs throughout the switching range.
Crowd fluid(const Molecule& molecule) {
  double sigma = 0;
  for (const Site& site : molecule.sites) sigma = std::max(sigma, diameter(site));
  const double edge = 3 * (1.1 * sigma + 1.2 * molecule.extent());
  Crowd made{scenes::spread({{{molecule, 27}}}, {edge, edge, edge}, 17), {}};
  made.forces = {.cutoff = 0.49 * edge, .switch_from = 0.25 * edge, .smoothness = 3};
  made.forces.skin = 0.01 * edge;
  return made;
}

// A cluster of four ions and four of the opposite charge, otherwise equal. The switching range is
// beyond their distances: its fourth derivative jumps, which for charges exceeds the error of a
// fourth-order scheme.
Crowd salt(const Molecule& ion) {
  Molecule opposite = ion;
  opposite.name += "-opposite";
  for (Site& site : opposite.sites) site.charge = -site.charge;
  const double apart = std::max(0.25, 1.1 * ion.sites[0].sigma);
  std::vector<Vec3<double>> places;
  for (int k = 0; k < 8; ++k)
    places.push_back(apart * Vec3<double>{k % 2 + 1.0, k / 2 % 2 + 1.0, k / 4 + 1.0});
  return {scenes::populated({{{ion, 4}, {opposite, 4}}}, {4, 4, 4}, places, 0.002, 17),
          {.cutoff = 1.9, .switch_from = 1.8, .smoothness = 3}};
}

Crowd crowd(const Molecule& molecule) {
  Crowd made = std::abs(molecule.charge()) > 0.5 ? salt(molecule) : fluid(molecule);
  // On a lattice, forces are too small, or for ions too large; a short run at 300 K lets bodies
  // approach each other.
  ForceField forces(made.scene.topology, made.forces, made.scene.state.box);
  Integrator integrator(scheme_of("velocity-verlet"), made.scene.bodies, forces);
  for (int k = 0; k < 20; ++k) {
    integrator.advance(made.scene.state, 0.0005, 20);
    rescale(made.scene.state, made.scene.topology, made.scene.bodies, 300);
    integrator.forget();
  }
  return made;
}

double mean_square(const Vec3Column& v) {
  double sum = 0;
  for (std::size_t i = 0; i < v.size(); ++i) sum += norm2(v[i]);
  return sum;
}

// The time in which momenta change completely: the shorter of |p|/|f| and |ℓ|/|τ| [ps].
double natural_time(const State& state, const Load& load) {
  const auto ratio = [](double momenta, double loads) {
    return momenta > 0 && loads > 0 ? std::sqrt(momenta / loads) : INFINITY;
  };
  return std::min(ratio(mean_square(state.p), mean_square(load.f)),
                  ratio(mean_square(state.ell), mean_square(load.tau)));
}

// Result of a run over eight samples.
struct Run {
  double energy_error = 0;  // the largest |E − E₀|, divided by the kinetic energy
  double momentum = 0;      // |P − P₀| [u nm/ps]
  double rounding = 0;      // limit of the momentum from rounding
};

Run run(const Crowd& made, const Scheme& scheme, double length, std::size_t steps) {
  constexpr double lambda = 1e-4;
  State state = made.scene.state;
  ForceField forces(made.scene.topology, made.forces, state.box);
  Integrator integrator(scheme, made.scene.bodies, forces, lambda);
  const Energies start = energies(state, made.scene.bodies, integrator.load(state));
  const Vec3<double> momentum = total_momentum(state);
  Run result;
  double force = 0;
  for (int k = 0; k < 8; ++k) {
    integrator.advance(state, length / double(8 * steps), steps);
    const Load& load = integrator.load(state);
    const Energies now = energies(state, made.scene.bodies, load);
    result.energy_error =
        std::max(result.energy_error, std::abs(now.total() - start.total()) / start.kinetic());
    force = std::max(force, largest(load.f));
  }
  result.momentum = norm(total_momentum(state) - momentum);
  // Every kick rounds the momenta of all bodies, and their forces are sums over all others; a
  // finite difference divides that by λ.
  const double n = double(state.size()), kicks = double(integrator.force_evaluations());
  const double gain = scheme.has(Gradient::finite_difference) ? 1 / lambda : 1;
  result.rounding =
      kicks * n * 0x1p-53 * (largest(state.p) + n * gain * force * length / double(8 * steps));
  return result;
}

}  // namespace

namespace {

// The error of E is C hᵏ (1 + c h²) at each time, so halving h divides it by 2ᵏ, and the deviation
// of the slope from k by 4. If halving changes the slope by less than 0.1, its deviation is smaller
// than that. Both sides are bounded.
void check_orders(const Crowd& made) {
  ForceField forces(made.scene.topology, made.forces, made.scene.state.box);
  Load load;
  forces(made.scene.state, load);
  const double length = 2 * natural_time(made.scene.state, load);
  // The third derivative of a spline jumps at its points, many of which are passed in a step:
  // fourth order needs more.
  const bool is_smooth = std::none_of(
      made.scene.topology.parts.begin(), made.scene.topology.parts.end(), [](const auto& part) {
        return std::holds_alternative<TabulatedLaw>(part.molecule.sites.front().law);
      });
  for (const char* text : {"velocity-verlet", "hoa2", "gier4"}) {
    CAPTURE(std::string(text));
    const Scheme scheme = scheme_of(text);
    if (scheme.order() > 2 && !is_smooth) continue;
    double error = 0, slope = 0, change = INFINITY;
    for (std::size_t steps = 2; steps <= 64 && !(change < 0.1); steps *= 2) {
      const Run result = run(made, scheme, length, steps);
      CHECK(result.momentum < result.rounding);
      const double now = std::log2(error / result.energy_error);
      change = std::abs(now - slope);
      error = result.energy_error, slope = now;
    }
    CHECK(change < 0.1);
    CHECK(std::abs(slope - scheme.order()) < 0.1);
  }
}

}  // namespace

TEST_CASE("energy is conserved to the order of the scheme, and momentum exactly, for every model") {
  for (const std::string& name : molecule_names()) {
    CAPTURE(name);
    check_orders(crowd(read_molecule(name)));
  }
}

// The compact split is of class C⁵ here and the mesh's forces are the gradient of its energy, so
// every order is preserved, whatever the accuracy of the mesh. Without their net force they are the
// gradient along every motion that leaves the centre of mass at rest, as here.
TEST_CASE(
    "energy is conserved to the order of the scheme, and momentum exactly, with the Ewald sum") {
  for (const char* name : {"tip4p", "co2", "na-spce"})
    for (const std::size_t points : {24u, 12u}) {
      CAPTURE(std::string(name));
      CAPTURE(points);
      Crowd made = crowd(read_molecule(name));
      made.forces.truncation = Truncation::site_switch;
      made.forces.electrostatics = Electrostatics::pme;
      made.forces.mesh = MeshSettings{{points, points, points}, 6, 4, made.forces.cutoff};
      check_orders(made);
    }
}

// A law of class C³ at the cutoff is smooth enough for fourth order, whatever the damping.
TEST_CASE("energy is conserved to the order of the scheme with the damped shifted force") {
  for (const char* name : {"tip4p", "na-spce"}) {
    CAPTURE(std::string(name));
    Crowd made = crowd(read_molecule(name));
    made.forces.truncation = Truncation::site_switch;
    made.forces.electrostatics = Electrostatics::damped_shifted_force;
    made.forces.smoothness = 3;
    made.forces.damping = 1.8 / made.forces.cutoff;
    check_orders(made);
  }
}

// The central difference of fourth order, (8 (U₁ − U₋₁) − (U₂ − U₋₂))/12 s, errs by s⁴ U⁽⁵⁾/30. At
// contacts of 0.2 nm U⁽⁵⁾ is 13 × 14 × 15 × 16/(0.2 nm)⁴ of a force: 1e-10 of it at s = 1e-4 nm,
// and at 1e-3 rad, which is 2.5e-4 nm at the longest arms, 4e-9. Rounding is smaller.
TEST_CASE("force and torque are minus the slope of the energy, for every model") {
  for (const std::string& name : molecule_names()) {
    CAPTURE(name);
    const Crowd made = crowd(read_molecule(name));
    ForceField forces(made.scene.topology, made.forces, made.scene.state.box);
    Load load;
    forces(made.scene.state, load);
    const auto slope = [&](auto move, double s) {
      const auto at = [&](double c) {
        State moved = made.scene.state;
        move(moved, c);
        Load there;
        forces(moved, there);
        return there.potential();
      };
      return (8 * (at(s) - at(-s)) - (at(2 * s) - at(-2 * s))) / (12 * s);
    };
    const std::size_t n = made.scene.state.size();
    for (const std::size_t i : {std::size_t{0}, n / 2, n - 1})
      for (std::size_t k = 0; k < 3; ++k) {
        Vec3<double> e{};
        e[k] = 1;
        const auto moved = [&](State& state, double c) { state.q.add(i, c * e); };
        const auto turned = [&](State& state, double c) {
          state.orientation.set(i, rotation_quaternion(c * e) * state.orientation[i]);
        };
        CHECK(std::abs(slope(moved, 1e-4) + load.f[i][k]) < 1e-8 * largest(load.f));
        CHECK(std::abs(slope(turned, 1e-3) + load.tau[i][k]) < 1e-8 * largest(load.f));
      }
  }
}
