// SPDX-License-Identifier: MIT
// Laws that hold for every scheme of the table.
#include "polhode/integrate/schemes.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "measure/order.hpp"
#include "polhode/integrate/integrator.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/measure/energy.hpp"
#include "scenes.hpp"
#include "unit/errors.hpp"

using namespace polhode;

namespace {

// Rounding error of momenta from one force evaluation of a gradient kick by finite difference: that
// of the forces, 2⁻⁵³ of the largest in the pair sums (about 10⁴ kJ/mol/nm at contact), divided by
// λ.
double rounding_gain(const Scheme& scheme, double lambda) {
  return scheme.has(Gradient::finite_difference) ? 1 / lambda : 1;
}

}  // namespace

// A symmetric scheme of order k has an energy error of C hᵏ + O(hᵏ⁺²), so halving h divides the
// error by 2ᵏ; at the steps where rounding is still negligible, the next order changes the slope by
// less than 0.1. Both sides are bounded: a slope that is too good is as wrong as one that is too
// bad.
TEST_CASE("the energy error of every scheme has its declared order") {
  for (const Scheme& scheme : schemes) {
    CAPTURE(std::string(scheme.name()));
    const OrderMeasurement m = measure_order(scheme);
    REQUIRE(m.points.size() > 3);
    CHECK(std::abs(m.order - scheme.order()) < 0.1);
  }
}

// The step in 2 ξ λ h² is the whole one; ξ for GIER4 follows from 1 − 6 η + 6 η² = 72 (1 − 2 η) ξ
// / 6.
TEST_CASE("a wrong factor of xi or a wrong weight breaks the fourth order of gier4") {
  for (const char* text :
       {"B(1/6) A(1/2) B(2/3, -1/48) A(1/2) B(1/6)", "B(1/6) A(1/2) B(2/3, 1/24) A(1/2) B(1/6)",
        "B(1/6) A(1/2) B(2/3, 1/72) A(1/2) B(1/6)"}) {
    CAPTURE(std::string(text));
    CHECK(std::abs(measure_order(scheme_of(text)).order - 2) < 0.1);
  }
}

// h → −h undoes a symmetric step exactly. What remains is the rounding of 2 × 100 steps as a random
// walk, amplified by the divergence of neighbouring trajectories, about 10² in 0.2 ps of water.
// Plain kicks round positions and momenta of order 1 and 10: 2⁻⁵³ × 10 × √200 × 10² = 2e-12 at
// most. Kicks by finite difference have torques of 10³ kJ/mol with an error of 2⁻⁵³ × 10³/λ = 1e-9,
// times h = 2e-3 ps a step: 3e-9 in ℓ; forces of 10⁴ kJ/mol/nm to 1e-8, times h²/m = 2e-7: 3e-12 in
// q. Bounds are 3 times that.
TEST_CASE("every scheme is reversible") {
  for (const Scheme& scheme : schemes) {
    CAPTURE(std::string(scheme.name()));
    scenes::Scene scene = scenes::water_cluster();
    ForceField forces(scene.topology, scenes::no_truncation(), scene.state.box);
    const State start = scene.state;
    Integrator integrator(scheme, scene.bodies, forces);
    integrator.advance(scene.state, 0.002, 100);
    CHECK(largest_difference(scene.state.q, start.q) > 0.01);  // the bodies did move
    integrator.advance(scene.state, -0.002, 100);
    CHECK(largest_difference(scene.state.q, start.q) <
          (scheme.has(Gradient::finite_difference) ? 1e-9 : 6e-12));
    CHECK(largest_difference(scene.state.ell, start.ell) <
          (scheme.has(Gradient::finite_difference) ? 1e-8 : 6e-12));
  }
}

// Pair forces are equal and opposite to the bit in the sums of two bodies; what remains is the
// rounding of the sums: forces up to 10³ kJ/mol/nm, each kick with h = 2e-3 ps adding 2⁻⁵³ × 10³ ×
// 2e-3 ≈ 2e-16 per body, 5 bodies, 200 steps of up to 4 kicks as a random walk: 1e-14; times 1/λ
// for finite differences.
TEST_CASE("every scheme conserves the total momentum") {
  for (const Scheme& scheme : schemes) {
    CAPTURE(std::string(scheme.name()));
    scenes::Scene scene = scenes::lattice({{"tip4p", 27}}, 0.31, 2.1, 3);
    ForceSettings settings;
    settings.cutoff = 0.9, settings.switch_from = 0.75;
    ForceField forces(scene.topology, settings, scene.state.box);
    const Vec3<double> before = total_momentum(scene.state);
    Integrator integrator(scheme, scene.bodies, forces);
    integrator.advance(scene.state, 0.001, 200);
    CHECK(norm(total_momentum(scene.state) - before) < 1e-12 * rounding_gain(scheme, 1e-4));
  }
}

// Without a boundary the torques on a cluster cancel: Σ q × f + τ = 0 for pair forces along any
// direction that act at common points. Plain kicks keep Σ q × p + ℓ to rounding, and so do exact
// gradient kicks: W is invariant under rotations of the system.
TEST_CASE("plain kicks and exact gradients conserve the angular momentum of an isolated cluster") {
  for (const Scheme& scheme : schemes) {
    if (scheme.has(Gradient::finite_difference)) continue;
    CAPTURE(std::string(scheme.name()));
    scenes::Scene scene = scenes::water_cluster();
    ForceField forces(scene.topology, scenes::no_truncation(), scene.state.box);
    const Vec3<double> before = total_angular_momentum(scene.state);
    Integrator integrator(scheme, scene.bodies, forces);
    integrator.advance(scene.state, 0.001, 200);
    CHECK(norm(total_angular_momentum(scene.state) - before) < 1e-11);
  }
}

// A gradient kick by finite difference uses the forces at displaced positions but their arms at the
// undisplaced ones; the mismatch is (q̃ − q) × Δf, proportional to λ h² × h² × h per step: a loss
// of angular momentum linear in λ.
TEST_CASE(
    "gradient kicks by finite difference change the angular momentum in proportion to lambda") {
  double loss[2];
  const double lambdas[2] = {1e-1, 1e-2};
  for (int k = 0; k < 2; ++k) {
    scenes::Scene scene = scenes::water_cluster();
    ForceField forces(scene.topology, scenes::no_truncation(), scene.state.box);
    const Vec3<double> before = total_angular_momentum(scene.state);
    Integrator integrator(scheme_of("gier4-fd"), scene.bodies, forces, lambdas[k]);
    integrator.advance(scene.state, 0.004, 5);
    loss[k] = norm(total_angular_momentum(scene.state) - before);
  }
  CHECK(loss[0] / loss[1] == doctest::Approx(10).epsilon(0.05));  // next order in λ: λ h² f'/m ≪ 1
}

TEST_CASE("a scheme needs the number of force evaluations stated in the table") {
  for (const Scheme& scheme : schemes) {
    CAPTURE(std::string(scheme.name()));
    scenes::Scene scene = scenes::water_cluster();
    ForceField forces(scene.topology, scenes::no_truncation(), scene.state.box);
    Integrator integrator(scheme, scene.bodies, forces);
    integrator.advance(scene.state, 0.001, 10);
    const std::uint64_t first = integrator.force_evaluations();
    integrator.advance(scene.state, 0.001, 10);
    CHECK(integrator.force_evaluations() - first ==
          10 * static_cast<std::uint64_t>(scheme.force_evaluations()));
    CHECK(integrator.derivatives() == 20 * static_cast<std::uint64_t>(scheme.derivatives()));
    CHECK(forces.evaluations() == integrator.force_evaluations());
  }
}

// Single and merged steps are the same map; they differ by rounding, 2⁻⁵³ of momenta of order 10
// per kick, amplified over 0.02 ps.
TEST_CASE("merged steps equal single ones") {
  for (const Scheme& scheme : schemes) {
    CAPTURE(std::string(scheme.name()));
    scenes::Scene one = scenes::water_cluster(), merged = scenes::water_cluster();
    ForceField forces(one.topology, scenes::no_truncation(), one.state.box);
    Integrator a(scheme, one.bodies, forces), b(scheme, one.bodies, forces);
    for (int k = 0; k < 10; ++k) a.advance(one.state, 0.002);
    b.advance(merged.state, 0.002, 10);
    const double gain = rounding_gain(scheme, 1e-4);
    CHECK(largest_difference(one.state.q, merged.state.q) < 1e-14 * gain);
    CHECK(largest_difference(one.state.p, merged.state.p) < 1e-12 * gain);
  }
}

namespace {

// A spring to the origin that counts requests for energies.
struct Spring {
  int complete = 0, alone = 0;
  void operator()(const State& state, Load& load) {
    ++complete;
    load.van_der_waals = pull(state, load);
  }
  void forces_alone(const State& state, Load& load) {
    ++alone;
    pull(state, load);
    load.van_der_waals = 0;
  }
  void directional_derivative(const State& state, const Vec3Column& dq, const Vec3Column&,
                              Load& slope) const {
    for (std::size_t i = 0; i < state.size(); ++i) slope.f.set(i, -1.0 * dq[i]);
  }
  static double pull(const State& state, Load& load) {
    double energy = 0;
    for (std::size_t i = 0; i < state.size(); ++i) {
      load.f.set(i, -1.0 * state.q[i]);
      energy += norm2(state.q[i]) / 2;
    }
    return energy;
  }
};

// The same, without a derivative for gradient kicks.
struct PlainSpring {
  void operator()(const State& state, Load& load) {
    load.van_der_waals = Spring::pull(state, load);
  }
};

}  // namespace

TEST_CASE("a scheme with exact gradients refuses forces without a derivative") {
  const scenes::Scene scene = scenes::water_cluster();
  PlainSpring spring;
  check_error([&] { Integrator(scheme_of("gier4"), scene.bodies, spring); },
              {"the forces have no derivative", "gier4-fd"});
  Integrator(scheme_of("gier4-fd"), scene.bodies, spring);
}

// Energies are computed where a state is sampled and nowhere else: by the last kick of a scheme
// that ends with one, otherwise by a separate evaluation, which is not counted as part of the
// integration.
TEST_CASE("energies are computed only when requested") {
  for (const Scheme& scheme : schemes) {
    CAPTURE(std::string(scheme.name()));
    scenes::Scene scene = scenes::water_cluster();
    const auto energy = [&] {
      double sum = 0;
      for (std::size_t i = 0; i < scene.state.size(); ++i) sum += norm2(scene.state.q[i]) / 2;
      return sum;
    };
    const bool ends_in_kick = scheme.stages().back().flow == Flow::kick;
    Spring spring;
    Integrator integrator(scheme, scene.bodies, spring, 1e-4);
    integrator.advance(scene.state, 0.001, 3, false);
    CHECK(spring.complete == 0);
    CHECK(spring.alone == int(integrator.force_evaluations()));
    CHECK(integrator.measurements() == 0);
    CHECK(integrator.load(scene.state).potential() == doctest::Approx(energy()).epsilon(1e-14));
    CHECK(spring.complete == 1);
    CHECK(integrator.measurements() == 1);
    CHECK(integrator.load(scene.state).potential() == doctest::Approx(energy()).epsilon(1e-14));
    CHECK(integrator.measurements() == 1);  // still valid

    const auto evaluations = integrator.force_evaluations();
    integrator.advance(scene.state, 0.001, 3, true);
    CHECK(integrator.load(scene.state).potential() == doctest::Approx(energy()).epsilon(1e-14));
    CHECK(integrator.measurements() == (ends_in_kick ? 1 : 2));
    CHECK(spring.complete == 2);
    CHECK(spring.complete + spring.alone ==
          int(integrator.force_evaluations() + integrator.measurements()));
    CHECK(integrator.force_evaluations() > evaluations);
    integrator.forget();
    integrator.load(scene.state);
    CHECK(spring.complete == 3);
  }
}
