// SPDX-License-Identifier: MIT
// Shadow energies: the brackets from their definitions, and the conserved quantity of a scheme.
#include "polhode/measure/shadow.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "polhode/integrate/integrator.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/integrate/schemes.hpp"
#include "polhode/measure/squared_force.hpp"
#include "rms.hpp"
#include "scenes.hpp"

using namespace polhode;

namespace {

/// Bodies of all kinds in vacuum: asymmetric tops, linear ones, an atom.
scenes::Scene all_kinds() {
  return scenes::lattice({{"tip4p", 2}, {"n2", 2}, {"argon", 1}}, 0.42, 40, 5);
}

// Energies of two states have errors of 2⁻⁵³ of the terms of their sums, about 10 kJ/mol here.
constexpr double rounding = 1e-15;

double potential(scenes::Scene scene, ForceField& forces, double drifted) {
  drift(scene.state, scene.bodies, drifted);
  Load load;
  forces(scene.state, load);
  return load.potential();
}

}  // namespace

// V along the drift: its second difference with steps e and e/2 differs from V̈ by e²/12 V⁗ and a
// quarter of that; four thirds of the finer minus a third of the coarser leave O(e⁴). With rates of
// 100/ps at most, (100 e)⁴/1440 < 1e-7 at e = 1e-3 ps, and rounding is 10 × 1e-15/e² = 1e-8
// kJ/mol/ps² of about 10³ to 10⁵: 1e-6 relative is above both.
TEST_CASE("the first bracket is the second derivative of V along the drift") {
  for (const scenes::Scene& scene : {scenes::water_cluster(), all_kinds()}) {
    ForceField forces(scene.topology, scenes::no_truncation(), scene.state.box);
    Load load;
    forces(scene.state, load);
    const double exact = error_brackets(scene.state, scene.bodies, load, forces).second_derivative;
    const auto second_difference = [&](double e) {
      return (potential(scene, forces, e) - 2 * load.potential() + potential(scene, forces, -e)) /
             (e * e);
    };
    const double e = 1e-3;
    const double measured = (4 * second_difference(e / 2) - second_difference(e)) / 3;
    CHECK(std::abs(measured - exact) < 1e-6 * std::abs(exact) + 100 * rounding / (e * e));
    CHECK(std::abs(exact) > 1);
  }
}

// T is quadratic in momenta, so its second difference along the kick is W to rounding: T of about
// 10² kJ/mol, 1e-13 after sums, divided by e².
TEST_CASE("the second bracket is the second derivative of T along the kick, motion by motion") {
  for (const scenes::Scene& scene : {scenes::water_cluster(), all_kinds()}) {
    ForceField forces(scene.topology, scenes::no_truncation(), scene.state.box);
    Load load;
    forces(scene.state, load);
    const auto kinetic = [&](double e) {
      State state = scene.state;
      kick(state, scene.bodies, load, e);
      const Energies now = energies(state, scene.bodies, load);
      return ByMotion<double>{now.translation, now.rotation[0], now.rotation[1], now.rotation[2]};
    };
    const double e = 0.01;
    const ByMotion<double> parts = squared_force(scene.state, scene.bodies, load);
    const ByMotion<double> before = kinetic(-e), here = kinetic(0), after = kinetic(e);
    for (std::size_t k = 0; k < parts.size(); ++k)
      CHECK(std::abs((after[k] - 2 * here[k] + before[k]) / (e * e) - parts[k]) <
            1e-12 * parts[k] + 1e-13 / (e * e));
    const double W = error_brackets(scene.state, scene.bodies, load, forces).W;
    CHECK(W == doctest::Approx(parts[0] + parts[1] + parts[2] + parts[3]).epsilon(1e-14));
  }
}

namespace {

struct Fluctuations {
  double energy, shadow;
};

Fluctuations fluctuations(const scenes::Scene& start, const Scheme& scheme, double h, int steps) {
  scenes::Scene scene = start;
  ForceField forces(scene.topology, scenes::no_truncation(), scene.state.box);
  Integrator integrator(scheme, scene.bodies, forces);
  const ErrorTerms terms = error_terms(scheme);
  std::vector<double> energy, shadow;
  for (int n = 0; n < steps; ++n) {
    integrator.advance(scene.state, h);
    const Load& load = integrator.load(scene.state);
    const BracketSample sample{energies(scene.state, scene.bodies, load),
                               error_brackets(scene.state, scene.bodies, load, forces)};
    energy.push_back(sample.energies.total());
    shadow.push_back(shadow_energy(sample, terms, h));
  }
  return {fluctuation(energy), fluctuation(shadow)};
}

}  // namespace

// H̃ is conserved to O(h⁴), H to O(h²): halving the step divides the first fluctuation by 16, the
// second by 4. The next terms, of relative size (ω h)² with ω up to 200/ps, change the slopes by
// less than 0.15 with h = 1 fs and 0.5 fs; the longer trajectory samples the same stretch of time.
TEST_CASE("the shadow energy is conserved to fourth order, the energy to second order") {
  std::vector<Scheme> second_order{
      scheme_of("B(1/6) A(1/2) B(2/3, 1/24) A(1/2) B(1/6)"),  // a gradient of the wrong weight
      scheme_of("A(1/3) B(1/2, 1/50) A(1/3) B(1/2, 1/50) A(1/3)")};
  for (const Scheme& scheme : schemes)
    if (scheme.order() == 2) second_order.push_back(scheme);
  CHECK(second_order.size() > 5);
  for (const scenes::Scene& scene : {scenes::water_cluster(), all_kinds()})
    for (const Scheme& scheme : second_order) {
      CAPTURE(text_of(scheme));
      const Fluctuations coarse = fluctuations(scene, scheme, 0.001, 40);
      const Fluctuations fine = fluctuations(scene, scheme, 0.0005, 80);
      CHECK(std::abs(std::log2(coarse.energy / fine.energy) - 2) < 0.15);
      CHECK(std::abs(std::log2(coarse.shadow / fine.shadow) - 4) < 0.15);
      CHECK(coarse.shadow < 0.1 * coarse.energy);
    }
}
