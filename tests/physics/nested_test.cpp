// SPDX-License-Identifier: MIT
// Laws of multiple time steps: schemes within the drifts of others.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "measure/order.hpp"
#include "polhode/integrate/nested_integrator.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/io/settings/nested_scheme_text.hpp"
#include "polhode/measure/energy.hpp"
#include "polhode/run/simulation/trajectory/trajectory.hpp"
#include "run/simulation/system/near_forces.hpp"
#include "scenes.hpp"

using namespace polhode;

namespace {

// Kicks and drifts first, with a gradient and without, one drift and more, backward ones.
const char* const texts[] = {
    "velocity-verlet / velocity-verlet x 3 within 0.2 to 0.35 nm",
    "position-verlet / hoa2 x 2 within 0.2 to 0.35 nm",
    "velocity-verlet / position-verlet x 2 within 0.2 to 0.35 nm",
    "hoa2 / hoa2 x 2 within 0.2 to 0.35 nm",
    "hoa2 / gier4 x 1 within 0.2 to 0.35 nm",
    "forest-ruth / forest-ruth x 2 within 0.2 to 0.35 nm",
    "gier4 / forest-ruth x 2 within 0.2 to 0.35 nm",
    "gier4 / gier4 x 2 within 0.2 to 0.35 nm",
    "chin-4b / gier4 x 1 within 0.2 to 0.35 nm",
    "gier4-fd / gier4-fd x 2 within 0.2 to 0.35 nm",
};

// Their differences of forces amplify rounding by 1/λ.
bool by_difference(const NestedScheme& scheme) { return scheme.has(Gradient::finite_difference); }

// Near and all forces of a scene, and the integrator of both.
struct Split {
  Split(const scenes::Scene& scene, const ForceSettings& settings, const NestedScheme& scheme)
      : whole(scene.topology, settings, scene.state.box),
        near(scene.topology, near_settings(settings, *scheme.inner), scene.state.box),
        integrator(scheme, scene.bodies, whole, near) {}
  ForceField whole, near;
  NestedIntegrator<ForceField, ForceField> integrator;
};

}  // namespace

// The harmonic part of the field is near, the rest slow. Halving h halves both steps, so the energy
// error has the lower of the two orders; bounds as for single schemes. GIER4 around a near flow
// that is exact to fourth order needs the gradient of the slow forces alone: with the near ones in
// it, or at the wrong positions, the order is 2.
TEST_CASE("the energy error of a nested scheme has the lower of its two orders") {
  for (const char* text : texts) {
    CAPTURE(std::string(text));
    const NestedScheme scheme = nested_scheme_of(text);
    const OrderMeasurement m = measure_order(scheme);
    REQUIRE(m.points.size() > 3);
    CHECK(std::abs(m.order - scheme.order()) < 0.1);
  }
  for (const char* text : {"gier4 / hoa2 x 4 within 0.5 nm", "hoa2 / gier4 x 4 within 0.5 nm",
                           "B(1/6) A(1/2) B(2/3) A(1/2) B(1/6) / gier4 x 4 within 0.5 nm"}) {
    CAPTURE(std::string(text));
    CHECK(std::abs(measure_order(nested_scheme_of(text)).order - 2) < 0.1);
  }
}

// Bounds as for single schemes; inner kicks add their rounding, up to 4 times as many.
TEST_CASE("nested schemes are reversible") {
  for (const char* text : texts) {
    CAPTURE(std::string(text));
    const NestedScheme scheme = nested_scheme_of(text);
    scenes::Scene scene = scenes::water_cluster();
    Split split(scene, scenes::no_truncation(), scheme);
    const State start = scene.state;
    split.integrator.advance(scene.state, 0.002, 100);
    CHECK(largest_difference(scene.state.q, start.q) > 0.01);  // the bodies did move
    CHECK(scene.state.time == doctest::Approx(0.2).epsilon(1e-14));
    split.integrator.advance(scene.state, -0.002, 100);
    CHECK(largest_difference(scene.state.q, start.q) < (by_difference(scheme) ? 2e-9 : 1.2e-11));
    CHECK(largest_difference(scene.state.ell, start.ell) <
          (by_difference(scheme) ? 2e-8 : 1.2e-11));
  }
}

// Bounds as for single schemes, for as many more kicks.
TEST_CASE("nested schemes conserve the total momentum") {
  for (const char* text : texts) {
    CAPTURE(std::string(text));
    const NestedScheme scheme = nested_scheme_of(text);
    scenes::Scene scene = scenes::lattice({{"tip4p", 27}}, 0.31, 2.1, 3);
    Split split(scene, {.cutoff = 0.9, .switch_from = 0.75}, scheme);
    const Vec3<double> before = total_momentum(scene.state);
    split.integrator.advance(scene.state, 0.001, 50);
    CHECK(norm(total_momentum(scene.state) - before) < (by_difference(scheme) ? 2e-8 : 2e-12));
  }
}

// At the first force point there is no inner step yet whose forces would be known: one more.
TEST_CASE("a nested scheme needs the stated number of evaluations of both kinds") {
  for (const char* text : texts) {
    CAPTURE(std::string(text));
    const NestedScheme scheme = nested_scheme_of(text);
    scenes::Scene scene = scenes::water_cluster();
    Split split(scene, scenes::no_truncation(), scheme);
    split.integrator.advance(scene.state, 0.001, 5);
    const std::uint64_t whole = split.whole.evaluations(), near = split.near.evaluations();
    const std::uint64_t slopes = split.integrator.derivatives();
    const std::uint64_t near_slopes = split.integrator.near_derivatives();
    CHECK(near == split.integrator.near_evaluations());
    for (int k = 0; k < 5; ++k) split.integrator.advance(scene.state, 0.001);
    CHECK(split.whole.evaluations() - whole == 5u * unsigned(scheme.outer.force_evaluations()));
    CHECK(split.near.evaluations() - near == 5u * unsigned(scheme.near_evaluations()));
    CHECK(split.integrator.derivatives() - slopes == 5u * unsigned(scheme.outer.derivatives()));
    CHECK(split.integrator.near_derivatives() - near_slopes ==
          5u * unsigned(scheme.near_derivatives()));
  }
}

// Slow forces are all forces minus the near ones, up to the rounding of one subtraction of forces
// up to 10⁴ kJ/mol/nm, whatever the law; energies are the total ones. Two molecules closer than the
// switching distance of the near forces have no slow force, two beyond their cutoff no near one.
TEST_CASE("near and slow forces add up to all forces") {
  const NestedScheme scheme = nested_scheme_of("hoa2 / hoa2 x 2 within 0.35 to 0.5 nm");
  scenes::Scene scene = scenes::lattice({{"tip4p", 60}, {"co2", 4}}, 0.33, 2.1, 5);
  ForceSettings pme{.truncation = Truncation::site_switch,
                    .cutoff = 0.9,
                    .switch_from = 0.75,
                    .electrostatics = Electrostatics::pme};
  pme.pme_accuracy = 1e-4;
  ForceSettings reaction_field{.cutoff = 0.9, .switch_from = 0.75};
  reaction_field.electrostatics = Electrostatics::reaction_field;
  const ForceSettings plain{.cutoff = 0.9, .switch_from = 0.75};
  for (const ForceSettings& settings : {plain, reaction_field, pme}) {
    CAPTURE(int(settings.electrostatics));
    Split split(scene, settings, scheme);
    Load slow(scene.state.size()), near = slow, whole = slow;
    split.integrator.slow_forces()(scene.state, slow);
    split.near(scene.state, near);
    split.whole(scene.state, whole);
    CHECK(slow.potential() == whole.potential());
    double max_force = 0;
    for (std::size_t i = 0; i < slow.f.size(); ++i) {
      max_force = std::max(max_force, norm(slow.f[i]));
      CHECK(norm(slow.f[i] + near.f[i] - whole.f[i]) < 1e-11);
      CHECK(norm(slow.tau[i] + near.tau[i] - whole.tau[i]) < 1e-11);
    }
    CHECK(max_force > 1);  // there are slow forces
  }
  for (const double apart : {0.3, 0.6}) {
    scenes::Scene pair = scenes::lattice({{"tip4p", 2}}, 0.3, 2.1, 5);
    pair.state.q.set(0, {0.5, 0.5, 0.5});
    pair.state.q.set(1, {0.5, 0.5, 0.5 + apart});
    Split split(pair, plain, scheme);
    Load slow(2), near(2);
    split.integrator.slow_forces()(pair.state, slow);
    split.near(pair.state, near);
    const Load& nothing = apart < 0.35 ? slow : near;
    const Load& something = apart < 0.35 ? near : slow;
    CHECK(norm(nothing.f[0]) == 0);
    CHECK(norm(nothing.tau[0]) == 0);
    CHECK(norm(something.f[0]) > 0);
  }
}

namespace {

State moved(const NestedScheme& scheme, double h, std::size_t steps) {
  scenes::Scene scene = scenes::water_cluster();
  Split split(scene, scenes::no_truncation(), scheme);
  split.integrator.advance(scene.state, h, steps);
  return scene.state;
}

}  // namespace

// More inner steps change nothing but the error of the inner flow, which falls as n⁻ᵏ with the
// inner order k: the distance to the limit falls by 2ᵏ from n to 2 n, two-sided to the next term,
// n⁻² times that, about 0.1 at n = 4 steps of 0.5 fs. The limit is the outer scheme with the exact
// inner flow, so any inner scheme gives the same limit: here HOA2 and Forest-Ruth, within the error
// of HOA2 with n = 64.
TEST_CASE("with many inner steps the inner flow is exact") {
  const double h = 0.004;
  const auto with = [&](const std::string& inner, int n) {
    return moved(nested_scheme_of("velocity-verlet / " + inner + " x " + std::to_string(n) +
                                  " within 0.25 to 0.4 nm"),
                 h, 5);
  };
  const State exact = with("forest-ruth", 48);
  for (const auto& [inner, order] : {std::pair("hoa2", 2), std::pair("gier4", 4)}) {
    const auto shown_inner = std::string(inner);
    CAPTURE(shown_inner);
    const double coarse = largest_difference(with(inner, 4).q, exact.q);
    const double fine = largest_difference(with(inner, 8).q, exact.q);
    CHECK(std::abs(std::log2(coarse / fine) - order) < 0.2);
  }
  const double limit = largest_difference(with("hoa2", 64).q, exact.q);
  const double first = largest_difference(with("hoa2", 8).q, exact.q);
  CHECK(first / limit == doctest::Approx(64).epsilon(0.05));
  // while the outer scheme itself is far from the motion
  CHECK(largest_difference(
            moved(nested_scheme_of("velocity-verlet / forest-ruth x 12 within 0.25 to 0.4 nm"),
                  h / 4, 20)
                .q,
            exact.q) > 100 * limit);
}

// If near forces are all forces, slow ones are exactly 0, and the inner scheme with its step
// remains; if there are none, the outer one. In both cases flows are split differently than in a
// single scheme, so results differ by rounding, 2⁻⁵³ of momenta of order 10 per kick, grown over
// 0.04 ps.
TEST_CASE("near forces equal to all forces, or to none, reduce a nested scheme to a single one") {
  const auto difference = [](const State& a, const State& b) {
    return std::max(largest_difference(a.p, b.p), largest_difference(a.ell, b.ell));
  };
  const Scheme outer = scheme_of("hoa2"), inner = scheme_of("velocity-verlet");
  const NestedScheme scheme{outer, InnerScheme{inner, 2}};
  scenes::Scene start = scenes::water_cluster();
  const auto alone = [&](const Scheme& single, double h, std::size_t steps) {
    scenes::Scene scene = start;
    ForceField forces(scene.topology, scenes::no_truncation(), scene.state.box);
    Integrator(single, scene.bodies, forces).advance(scene.state, h, steps);
    return scene.state;
  };
  {
    scenes::Scene scene = start;
    ForceField whole(scene.topology, scenes::no_truncation(), scene.state.box);
    ForceField near(scene.topology, scenes::no_truncation(), scene.state.box);
    NestedIntegrator(scheme, scene.bodies, whole, near).advance(scene.state, 0.004, 10);
    CHECK(difference(scene.state, alone(inner, 0.001, 40)) < 1e-11);
    CHECK(difference(scene.state, alone(outer, 0.004, 10)) > 1e-5);
  }
  {
    scenes::Scene scene = start;
    ForceField whole(scene.topology, scenes::no_truncation(), scene.state.box);
    auto nothing = [](const State&, Load&) {};
    NestedIntegrator(scheme, scene.bodies, whole, nothing).advance(scene.state, 0.004, 10);
    CHECK(difference(scene.state, alone(outer, 0.004, 10)) < 1e-11);
  }
}

namespace {

System water(Precision precision) {
  scenes::Scene scene = scenes::lattice({{"tip4p", 216}}, 0.31, 1.9, 9);
  ForceSettings settings{.cutoff = 0.9, .switch_from = 0.75};
  settings.precision = precision;
  return {scene.topology, scene.bodies, scene.state, settings, 297};
}

Trajectory followed(System& system, const NestedScheme& scheme, int threads, Energies& last) {
  Workers workers(threads);
  ForceField forces(system.topology, system.forces, system.state.box, workers);
  return run_trajectory(
      system, forces,
      {.scheme = scheme.outer,
       .step = 0.001,
       .length = 0.02,
       .sample = 0.005,
       .lambda = system.forces.precision == Precision::mixed ? 1 : 1e-4,
       .inner = scheme.inner},
      {.sample = [&](std::size_t, const State&, const Energies& now) { last = now; }}, workers);
}

}  // namespace

// Blocks and chunks do not depend on the number of threads, nor does the difference of two sums.
TEST_CASE(
    "a nested trajectory has the same bits for any number of threads, and energies of all forces") {
  for (const char* text :
       {"hoa2 / velocity-verlet x 2 within 0.5 nm", "gier4 / gier4 x 1 within 0.5 nm",
        "gier4-fd / gier4-fd x 1 within 0.5 nm"})
    for (const Precision precision : {Precision::double_precision, Precision::mixed}) {
      CAPTURE(std::string(text));
      CAPTURE(int(precision));
      const NestedScheme scheme = nested_scheme_of(text);
      System alone = water(precision);
      Energies last{}, other{};
      const Trajectory t = followed(alone, scheme, 1, last);
      REQUIRE(t.failure.empty());
      CHECK(t.steps == 20);
      CHECK(t.near_evaluations > 20u * unsigned(scheme.near_evaluations()) - 20);
      CHECK(t.timings.near > 0);
      ForceField forces(alone.topology, alone.forces, alone.state.box);
      Load load(alone.state.size());
      forces(alone.state, load);
      CHECK(
          last.potential() ==
          doctest::Approx(load.potential()).epsilon(precision == Precision::mixed ? 1e-5 : 1e-12));
      for (const int threads : {2, 5}) {
        System shared = water(precision);
        followed(shared, scheme, threads, other);
        CHECK(other.total() == last.total());
        CHECK(largest_difference(shared.state.p, alone.state.p) == 0);
        CHECK(largest_difference(shared.state.ell, alone.state.ell) == 0);
      }
    }
}
