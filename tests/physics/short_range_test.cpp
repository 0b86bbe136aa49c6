// SPDX-License-Identifier: MIT
// Systems with other short-range laws than Lennard-Jones: the loops against plain sums, gradients,
// the cutoff, the correction beyond it, and what is refused.
#include <doctest/doctest.h>

#include <cmath>

#include "forces/laws/law_range.hpp"
#include "forces/laws/tail.hpp"
#include "instruction_sets.hpp"
#include "physics/force_laws.hpp"
#include "polhode/integrate/integrator.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/measure/energy.hpp"
#include "polhode/run/simulation/system/system.hpp"
#include "unit/errors.hpp"

using namespace polhode;

namespace {

struct Example {
  std::string name;
  scenes::Scene scene;
  Mixing mixing{};
};

// A made-up water whose oxygen and hydrogens have Buckingham laws.
Molecule buckingham_water() {
  const ShortRangeLaw oxygen = BuckinghamLaw{9e5, 38, 2.6e-3}, hydrogen = BuckinghamLaw{2e3, 35, 0};
  return rigid_molecule(
      "exp6-water",
      {{.name = "O", .element = "O", .r = {0, 0, 0}, .mass = 16, .charge = -0.8, .law = oxygen},
       {.name = "H1",
        .element = "H",
        .r = {0.08, 0.06, 0},
        .mass = 1,
        .charge = 0.4,
        .law = hydrogen},
       {.name = "H2",
        .element = "H",
        .r = {-0.08, 0.06, 0},
        .mass = 1,
        .charge = 0.4,
        .law = hydrogen}});
}

Molecule mie_dumbbell() {
  return rigid_molecule("mie-dumbbell", {{.name = "A",
                                          .element = "C",
                                          .r = {-0.1, 0, 0},
                                          .mass = 15,
                                          .charge = 0.1,
                                          .sigma = 0.33,
                                          .epsilon = 0.9,
                                          .law = MieLaw{14.5, 6}},
                                         {.name = "B",
                                          .element = "C",
                                          .r = {0.1, 0, 0},
                                          .mass = 14,
                                          .charge = -0.1,
                                          .sigma = 0.36,
                                          .epsilon = 0.7,
                                          .law = MieLaw{20, 5.5}}});
}

Example made(std::string name, const Topology& topology, Mixing mixing = {}) {
  const double box = 1.9;
  return {std::move(name), scenes::spread(topology, {box, box, box}, 5), std::move(mixing)};
}

// One system for each law, with charges and unlike sites; in the last, pairs of Lennard-Jones,
// tabulated and given laws meet.
std::vector<Example> systems() {
  const Molecule mie = mie_dumbbell(), argon = read_molecule("argon-ab-initio");
  return {
      made("Mie", {{{read_molecule("argon-mie"), 24}, {read_molecule("cf4-mie"), 16}, {mie, 24}}}),
      made("Buckingham", {{{buckingham_water(), 32}, {read_molecule("argon-buckingham"), 24}}}),
      made("tabulated", {{{read_molecule("tip4p"), 32}, {argon, 24}}},
           {.pairs = {{"argon-ab-initio.Ar", "tip4p.OW", 0.34, 0.8}}})};
}

double largest_distance(const Vec3Column& a, const Vec3Column& b) {
  double m = 0;
  for (std::size_t i = 0; i < a.size(); ++i) m = std::max(m, norm(a[i] - b[i]));
  return m;
}

ForceSettings with(const NamedLaw& law, const Example& system) {
  ForceSettings settings = law.settings;
  settings.mixing = system.mixing;
  return settings;
}

}  // namespace

// The force between charges whose product is e²/2 at 0.2 nm, as in a hydrogen bond [kJ/mol/nm]:
// terms of this size and either sign sum to much less.
namespace {
constexpr double charge_force = units::coulomb * 0.5 / (0.2 * 0.2);
}

// In double, sums of some 10³ terms that agree but for the order of sums and the last digits of
// powers: 20 roundings of 2⁻⁵³ each and their sum. In float, powers of up to 43 respond to the
// rounding of r² and of the logarithm about 100 times: 100 × 2⁻²⁴ of the largest force. Forces of
// charges have some ten roundings each and add up in a random walk: 20 × 2⁻²⁴ of one of them.
TEST_CASE("forces of all short-range laws over the list equal plain sums, on every target") {
  for (const Example& system : systems())
    for (const NamedLaw& law : all_laws()) {
      CAPTURE(system.name);
      CAPTURE(law.name);
      const scenes::Scene& scene = system.scene;
      ForceSettings settings = with(law, system);
      const auto exact =
          reference_load(scene.topology, settings, scene.state.box, scenes::poses(scene.state));
      const double force = largest(load_of(scene.topology, settings, scene.state).f);
      for (const Precision precision : {Precision::double_precision, Precision::mixed}) {
        settings.precision = precision;
        const bool mixed = precision == Precision::mixed;
        const double scale =
            (mixed ? 100 * 0x1p-24 : 1e-12) * force + (mixed ? 20 * 0x1p-24 : 0) * charge_force;
        for_each_instruction_set([&] {
          const Load load = load_of(scene.topology, settings, scene.state);
          CHECK(largest_difference(load.f, exact.f) < scale);
          CHECK(largest_difference(load.tau, exact.tau) < scale);
          CHECK(largest_difference(load.virial, exact.virial) < 10 * scale);  // about 10 nm in all
          CHECK(std::abs(load.van_der_waals - exact.van_der_waals) < 10 * scale);
        });
      }
    }
}

// As in forces_test: dU = −Σ f·dq + τ·dθ, with dU from dual numbers.
TEST_CASE("forces of all short-range laws are minus the gradient of the energy") {
  for (const Example& system : systems())
    for (const NamedLaw& law : all_laws()) {
      CAPTURE(system.name);
      CAPTURE(law.name);
      const scenes::Scene& scene = system.scene;
      const ForceSettings settings = with(law, system);
      const Load load = load_of(scene.topology, settings, scene.state);
      const std::size_t n = scene.state.size();
      for (const std::size_t i : {std::size_t{0}, n / 2, n - 1}) {
        Vec3Column dq(n), none(n), dtheta(n);
        const Vec3<double> e{0.6, -0.48, 0.64};
        dq.set(i, e);
        dtheta.set(i, to_body(scene.state.orientation[i], e));
        const auto slope = [&](const Vec3Column& by, const Vec3Column& turn) {
          return reference_derivative(scene.topology, settings, scene.state, by, turn).potential();
        };
        CHECK(std::abs(slope(dq, none) + dot(load.f[i], e)) < 1e-12 * largest(load.f));
        CHECK(std::abs(slope(none, dtheta) + dot(load.tau[i], e)) < 1e-12 * largest(load.f));
      }
    }
}

// As above, one power of the distance more.
TEST_CASE("derivatives of all short-range laws over the list equal dual numbers") {
  for (const Example& system : systems())
    for (const NamedLaw& law : all_laws()) {
      if (law.settings.smoothness == 1) continue;
      CAPTURE(system.name);
      CAPTURE(law.name);
      const scenes::Scene& scene = system.scene;
      ForceSettings settings = with(law, system);
      Vec3Column dq(scene.state.size()), dtheta(scene.state.size());
      std::mt19937_64 random(2);
      std::normal_distribution<double> normal;
      const auto vector = [&] {
        const double x = normal(random), y = normal(random), z = normal(random);
        return Vec3<double>{x, y, z};
      };
      for (std::size_t i = 0; i < scene.state.size(); ++i)
        dq.set(i, vector()), dtheta.set(i, vector());
      const Load exact = reference_derivative(scene.topology, settings, scene.state, dq, dtheta);
      for (const Precision precision : {Precision::double_precision, Precision::mixed}) {
        settings.precision = precision;
        const bool mixed = precision == Precision::mixed;
        const double scale = (mixed ? 200 * 0x1p-24 : 1e-11) * largest(exact.f) +
                             (mixed ? 20 * 0x1p-24 : 0) * charge_force * 3 / 0.2;
        for_each_instruction_set([&] {
          Load slope;
          ForceField(scene.topology, settings, scene.state.box)
              .directional_derivative(scene.state, dq, dtheta, slope);
          CHECK(largest_distance(slope.f, exact.f) < scale);
          CHECK(largest_distance(slope.tau, exact.tau) < scale);
        });
      }
    }
}

// A pair of atoms approaches the cutoff: u and f vanish there as the class of the truncation says,
// and within 1e-4 of the cutoff they are below the law by that power of 1e-4/0.15.
TEST_CASE("all short-range laws end at the cutoff") {
  for (const char* model : {"argon-mie", "cf4-mie", "argon-buckingham", "argon-ab-initio"})
    for (const Truncation truncation :
         {Truncation::molecule_switch, Truncation::site_switch, Truncation::site_shift}) {
      CAPTURE(std::string(model));
      const Topology topology{{{read_molecule(model), 2}}};
      State state(2, Box{{4, 4, 4}});
      const auto load_at = [&](double r) {
        state.q.set(1, {r, 0, 0});
        return load_of(topology, {truncation, 1.0, 0.85, 2}, state);
      };
      const Load inside = load_at(0.8);
      CHECK(std::abs(load_at(1 - 1e-4).van_der_waals) < 1e-4 * std::abs(inside.van_der_waals));
      CHECK(norm(load_at(1 - 1e-4).f[1]) < 0.01 * norm(inside.f[1]));
      CHECK(load_at(1 + 1e-9).van_der_waals == 0);
      CHECK(norm(load_at(1 + 1e-9).f[1]) == 0);
    }
}

// A switch cuts energy off; with the correction, a uniform fluid of any cutoff has the same: the
// correction at 0.9 nm less that at 1.3 nm is the energy between the two switches, summed here over
// shells as N²/2V ∫ 4π r² u (w₁.₃ − w₀.₉) dr; both without 1/V.
TEST_CASE("the dispersion correction of all laws is the energy that the truncation leaves out") {
  for (const char* model : {"argon-mie", "cf4-mie", "argon-buckingham"}) {
    CAPTURE(std::string(model));
    const Topology topology{{{read_molecule(model), 100}}};
    const Site& site = topology.parts[0].molecule.sites[0];
    const auto law = short_range(site.sigma, site.epsilon, site.law);
    const ForceSettings near{.cutoff = 0.9, .switch_from = 0.7},
        far{.cutoff = 1.3, .switch_from = 1};
    const Switch<> w_near(0.7, 0.9, 2), w_far(1, 1.3, 2);
    double sum = 0;
    constexpr int steps = 60'000;  // the midpoint rule errs by 1e-9
    const double h = 0.6 / steps;
    for (int k = 0; k < steps; ++k) {
      const double r = 0.7 + (k + 0.5) * h;
      sum += h * r * r * law(InversePowers<double>(r * r), r * r).u * (w_far(r).w - w_near(r).w);
    }
    const double expected = 100.0 * 100 / 2 * 4 * units::pi * sum;
    CHECK(dispersion_tail(topology, near) - dispersion_tail(topology, far) ==
          doctest::Approx(expected).epsilon(1e-7));
  }
}

TEST_CASE("what a law cannot do is refused") {
  const Topology argon{{{read_molecule("argon-ab-initio"), 2}}};
  const Box box{{5, 5, 5}};
  ForceSettings corrected{.cutoff = 1.2, .switch_from = 1};
  corrected.dispersion_correction = true;
  check_error([&] { ForceField(argon, corrected, box); },
              {"a dispersion correction needs the potential at all distances",
               "leave dispersion_correction and slab_dispersion out"});
  check_error([&] { ForceField(argon, {.cutoff = 1.7, .switch_from = 1}, box); },
              {"ends at 1.6 nm, but sites interact up to 1.7 nm", "shorter cutoff"});
  const Topology unlike{{{read_molecule("argon-ab-initio"), 2}, {read_molecule("argon"), 2}}};
  check_error([&] { ForceField(unlike, {.cutoff = 1.2, .switch_from = 1}, box); },
              {"for which there is no mixing rule", "[[pair]]"});
}

// Closer than the inner limit Buckingham's law falls to −∞: the energy is not a number, which ends
// a run, and the note says why.
TEST_CASE("sites inside the inner limit have no energy") {
  for (const char* model : {"argon-buckingham", "argon-ab-initio"})
    for (const Precision precision : {Precision::double_precision, Precision::mixed})
      for_each_instruction_set([&] {
        const Topology topology{{{read_molecule(model), 2}}};
        State state(2, Box{{4, 4, 4}});
        state.q.set(1, {0.07, 0, 0});
        ForceSettings settings{.cutoff = 1.2, .switch_from = 1};
        settings.precision = precision;
        CHECK(std::isnan(load_of(topology, settings, state).van_der_waals));
        CHECK(inner_limit_note(topology).find(
                  "the shortest distance at which their potential is valid") != std::string::npos);
      });
  CHECK(inner_limit_note({{{read_molecule("tip4p"), 1}}}).empty());
}

// A symmetric scheme of second order keeps the energy to C h² without energy drift: halving the
// step divides the error by 4, to within the next order.
TEST_CASE("runs with all short-range laws conserve the energy") {
  for (const Example& system : systems()) {
    CAPTURE(system.name);
    const ForceSettings settings = [&] {
      ForceSettings s{Truncation::site_switch, 0.75, 0.6, 3, Electrostatics::damped_shifted_force};
      s.mixing = system.mixing;
      return s;
    }();
    State calm = system.scene.state;
    {
      ForceField forces(system.scene.topology, settings, calm.box);
      Integrator integrator(scheme_of("velocity-verlet"), system.scene.bodies, forces);
      for (int k = 0; k < 20; ++k) {
        integrator.advance(calm, 0.0002, 20);
        rescale(calm, system.scene.topology, system.scene.bodies, 200);
        integrator.forget();
      }
    }
    const auto error = [&](double step) {
      State state = calm;
      ForceField forces(system.scene.topology, settings, state.box);
      Integrator integrator(scheme_of("velocity-verlet"), system.scene.bodies, forces);
      const auto total = [&] {
        return energies(state, system.scene.bodies, integrator.load(state)).total();
      };
      const double first = total();
      double worst = 0;
      for (int k = 0; k < 20; ++k) {
        integrator.advance(state, step, std::size_t(std::lround(0.01 / step)));
        worst = std::max(worst, std::abs(total() - first));
      }
      return worst;
    };
    const double ratio = error(0.001) / error(0.0005);
    CHECK(ratio > 3.2);
    CHECK(ratio < 5);
  }
}
