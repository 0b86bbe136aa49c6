// SPDX-License-Identifier: MIT
// Laws of schemes with a bath: one that does nothing, one that damps, one with random numbers.
#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "polhode/integrate/nested_integrator.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/integrate/schemes.hpp"
#include "polhode/io/settings/nested_scheme_text.hpp"
#include "polhode/math/random.hpp"
#include "run/simulation/system/near_forces.hpp"
#include "scenes.hpp"
#include "unit/errors.hpp"

using namespace polhode;

namespace {

constexpr const char* baoab = "B(1/2) A(1/2) O(1) A(1/2) B(1/2)";

struct Idle {
  void operator()(State&, double, StageNumber) const {}
};

void scale(State& state, double factor) {
  for (Vec3Column* momenta : {&state.p, &state.ell})
    for (std::size_t i = 0; i < state.size(); ++i) momenta->set(i, factor * (*momenta)[i]);
}

// p ← e^{−γt} p, ℓ ← e^{−γt} ℓ.
struct Damping {
  double gamma;  // [1/ps]
  void operator()(State& state, double t, StageNumber) const { scale(state, std::exp(-gamma * t)); }
};

// Shakes momenta by random numbers of the stage's own.
struct Shaking {
  void operator()(State& state, double t, StageNumber at) const {
    for (std::size_t i = 0; i < state.size(); ++i) {
      Random random(derived_seed(at.step, at.stage), i);
      const double x = random.normal(), y = random.normal(), z = random.normal();
      state.p.set(i, state.p[i] + t * Vec3<double>{x, y, z});
    }
  }
};

bool equal(const State& a, const State& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a.q[i] != b.q[i] || a.p[i] != b.p[i] || a.ell[i] != b.ell[i] ||
        a.orientation[i] != b.orientation[i])
      return false;
  return a.time == b.time;
}

// The angle between two orientations is twice that of their quaternions.
double largest_angle(const QuaternionColumn& a, const QuaternionColumn& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    largest = std::max(largest, 2 * norm((conjugate(a[i]) * b[i]).vector()));
  return largest;
}

// Half a bath before a stage, the other half after its mirror image.
Scheme with_bath_before(const Scheme& scheme, std::size_t k) {
  const auto stages = scheme.stages();
  std::vector<Stage> all(stages.begin(), stages.end());
  all.insert(all.end() - static_cast<std::ptrdiff_t>(k), O(0.5));
  all.insert(all.begin() + static_cast<std::ptrdiff_t>(k), O(0.5));
  return {all, scheme.order()};
}

template <class Forces, class Bath>
Integrator<Forces, FreeDrift, Bath> with_bath(const Scheme& scheme, const Bodies& bodies,
                                              Forces& forces, Bath bath) {
  return {scheme, bodies, forces, FreeDrift{bodies, Workers::serial()}, bath};
}

}  // namespace

// Step by step no stages are joined, so that all flows are the same; over several steps at once
// they are, unless the bath stands between them.
TEST_CASE("a bath that does nothing leaves every trajectory as it was, to the bit, at no cost") {
  const scenes::Scene scene = scenes::water_cluster();
  const auto field = [&] {
    return ForceField(scene.topology, scenes::no_truncation(), scene.state.box);
  };
  for (const Scheme& scheme : schemes) {
    CAPTURE(std::string(scheme.name()));
    for (std::size_t k = 0; 2 * k < scheme.stages().size(); ++k) {
      CAPTURE(k);
      const Scheme bathed = with_bath_before(scheme, k);
      CHECK(bathed.consistent());
      CHECK(bathed.palindromic());
      CHECK(bathed.force_evaluations() == scheme.force_evaluations());
      CHECK(bathed.cost() == scheme.cost());
      State without = scene.state, with = scene.state;
      ForceField forces = field(), its_forces = field();
      Integrator integrator(scheme, scene.bodies, forces);
      auto other = with_bath(bathed, scene.bodies, its_forces, Idle{});
      for (const std::size_t steps : {1u, 1u, k == 0 ? 1u : 3u}) {
        integrator.advance(without, 0.002, steps);
        other.advance(with, 0.002, steps);
      }
      CHECK(equal(without, with));
      CHECK(integrator.load(without).potential() == other.load(with).potential());
      CHECK(integrator.force_evaluations() == other.force_evaluations());
      CHECK(integrator.derivatives() == other.derivatives());
      CHECK(integrator.measurements() == other.measurements());
      CHECK(its_forces.evaluations() == other.force_evaluations() + other.measurements());
    }
  }
}

// Two-sided: no evaluation more, and none less.
TEST_CASE("a scheme with baths costs as many evaluations as it says") {
  const scenes::Scene scene = scenes::water_cluster();
  for (const auto& [text, evaluations, derivatives] :
       std::vector<std::tuple<const char*, int, int>>{
           {baoab, 1, 0},
           {"O(1/2) B(1/2) A(1) B(1/2) O(1/2)", 1, 0},
           {"A(1/2) B(1/2) O(1) B(1/2) A(1/2)", 1, 0},
           {"B(1/2) A(1) O(1) B(1/2)", 1, 0},
           {"B(1/2) A(1) B(1/2) O(1)", 1, 0},
           {"O(1) A(1/2) B(1) A(1/2)", 1, 0},
           {"B(1/6) A(1/2) O(1/2) B(2/3, 1/48) O(1/2) A(1/2) B(1/6)", 2, 1},
           {"B(1/6) A(1/2) O(1/2) B(2/3, 1/48, fd) O(1/2) A(1/2) B(1/6)", 3, 0},
           // The bath keeps the gradient kicks of two steps apart.
           {"O(1/2) B(1/2, 1/48) A(1) B(1/2, 1/48) O(1/2)", 1, 2},
           {"B(1/2, 1/48) A(1/2) O(1) A(1/2) B(1/2, 1/48)", 1, 1}}) {
    const auto shown_text = std::string(text);
    CAPTURE(shown_text);
    const Scheme scheme = scheme_of(text);
    CHECK(scheme.force_evaluations() == evaluations);
    CHECK(scheme.derivatives() == derivatives);
    ForceField forces(scene.topology, scenes::no_truncation(), scene.state.box);
    State state = scene.state;
    auto integrator = with_bath(scheme, scene.bodies, forces, Idle{});
    integrator.advance(state, 0.001, 10);
    const std::uint64_t first = integrator.force_evaluations(), slopes = integrator.derivatives();
    integrator.advance(state, 0.001, 10);
    const std::uint64_t measured = integrator.derivatives() - slopes;
    CHECK(integrator.force_evaluations() - first == 10u * unsigned(evaluations));
    // The last kick of ten steps is joined with none, so its gradient is evaluated as well.
    CHECK(measured >= 10u * unsigned(derivatives));
    CHECK(measured <= 10u * unsigned(derivatives) + 1);
    CHECK(forces.evaluations() == integrator.force_evaluations());
  }
}

TEST_CASE("energies wanted after a step that ends with a bath are those of its last kick") {
  const scenes::Scene scene = scenes::water_cluster();
  for (const char* text : {"B(1/2) A(1) B(1/2) O(1)", "B(1/2) A(1) B(1/2) O(1/2) O(1/2)",
                           "O(1/2) B(1/2) A(1) B(1/2) O(1/2)", "A(1/2) O(1) A(1/2) B(1)"}) {
    CAPTURE(std::string(text));
    ForceField forces(scene.topology, scenes::no_truncation(), scene.state.box);
    State state = scene.state;
    auto integrator = with_bath(scheme_of(text), scene.bodies, forces, Idle{});
    integrator.advance(state, 0.001, 3, true);
    ForceField fresh(scene.topology, scenes::no_truncation(), scene.state.box);
    Load load(state.size());
    fresh(state, load);
    CHECK(integrator.load(state).potential() ==
          doctest::Approx(load.potential()).epsilon(1e-12));  // rounding of sums in another order
    CHECK(integrator.measurements() == 0);
  }
}

// Without forces all momenta decay as e^{−γt}. Rates of motion are proportional to momenta, so that
// bodies go through the free motion at the time τ = ∫e^{−γt}dt = (1 − e^{−γt})/γ: the drift over τ
// is exact for flight and rotation alike. In BAOAB each step is a half at the old momenta and a
// half at the new ones: the drift over the trapezoidal sum of the integral, to the rounding of 2n
// rotations, 2⁻⁵³ each; the sum's own error, of order 2, is γ²h²/12 τ, and the next order is
// γ²h²/60 of that: 1e-4, or 2e-4 in the slope.
TEST_CASE("free bodies in a bath that damps go through the free motion ever slower") {
  constexpr double gamma = 4, length = 0.4;
  const scenes::Scene scene = scenes::lattice({{"tip4p", 6}, {"co2", 2}, {"argon", 2}}, 0.4, 3, 5);
  const auto moved = [&](double tau) {
    State state = scene.state;
    drift(state, scene.bodies, tau);
    return state;
  };
  const State exact = moved((1 - std::exp(-gamma * length)) / gamma);
  double flight[2], rotation[2];
  for (const int finer : {0, 1}) {
    const int steps = finer ? 80 : 40;
    const double h = length / steps;
    State state = scene.state;
    with_bath(scheme_of(baoab), scene.bodies, scenes::no_forces, Damping{gamma})
        .advance(state, h, static_cast<std::size_t>(steps));
    double tau = 0;
    for (int n = 0; n < steps; ++n)
      tau += h * (std::exp(-gamma * n * h) + std::exp(-gamma * (n + 1) * h)) / 2;
    CHECK(largest_difference(state.q, moved(tau).q) < 1e-14);
    CHECK(largest_angle(state.orientation, moved(tau).orientation) < 1e-13);
    flight[finer] = largest_difference(state.q, exact.q);
    rotation[finer] = largest_angle(state.orientation, exact.orientation);
    scale(state, std::exp(gamma * length));
    CHECK(largest_difference(state.p, scene.state.p) < 80 * 0x1p-52 * 20);  // momenta up to 20
    CHECK(largest_difference(state.ell, scene.state.ell) < 80 * 0x1p-52);
  }
  CHECK(std::abs(std::log2(flight[0] / flight[1]) - 2) < 5e-4);
  CHECK(std::abs(std::log2(rotation[0] / rotation[1]) - 2) < 0.01);  // chord for angle, too
}

namespace {

// A spring to the origin for every body [kJ/mol/nm²].
constexpr double spring = 2000;
void pull(const State& state, Load& load) {
  for (std::size_t i = 0; i < state.size(); ++i) load.f.set(i, -spring * state.q[i]);
}

// q of a damped oscillator: m q̈ = −k q − γ m q̇.
double damped(double q, double v, double k_over_m, double gamma, double t) {
  const double frequency = std::sqrt(k_over_m - gamma * gamma / 4);
  return std::exp(-gamma * t / 2) *
         (q * std::cos(frequency * t) + (v + gamma * q / 2) / frequency * std::sin(frequency * t));
}

}  // namespace

// A palindrome errs in even powers of h alone: order 2, whatever the order of the scheme without
// the bath. A bath at one end makes it 1: the momenta there differ by γh/2 of themselves. The phase
// errs by ω³h²t/24, with ω = 10/ps, which is ω³ht/(12γ) = 17 h/ps of that: 0.03 at the coarser
// step. At order 2 the next order is (ωh)² of the first: 4e-4.
TEST_CASE("bodies on springs in a bath that damps oscillate as damped oscillators, to order h²") {
  constexpr double gamma = 3, length = 0.6;
  const scenes::Scene scene = scenes::lattice({{"tip4p", 3}, {"argon", 3}}, 0.3, 3, 5);
  const auto error = [&](const char* text, int steps) {
    State state = scene.state;
    with_bath(scheme_of(text), scene.bodies, pull, Damping{gamma})
        .advance(state, length / steps, static_cast<std::size_t>(steps));
    double sum = 0;
    for (std::size_t i = 0; i < state.size(); ++i)
      for (std::size_t c = 0; c < 3; ++c) {
        const double m = scene.bodies.m[i];
        const double exact =
            damped(scene.state.q[i][c], scene.state.p[i][c] / m, spring / m, gamma, length);
        sum += std::pow(state.q[i][c] - exact, 2);
      }
    return std::sqrt(sum);
  };
  for (const auto& [text, order] :
       {std::pair{baoab, 2},
        {"O(1/2) B(1/2) A(1) B(1/2) O(1/2)", 2},
        {"A(1/2) B(1/2) O(1) B(1/2) A(1/2)", 2},
        {"A(1/2) O(1/2) B(1) O(1/2) A(1/2)", 2},
        {"B(1/6) A(1/2) O(1/2) B(2/3, 1/48, fd) O(1/2) A(1/2) B(1/6)", 2},
        {"B(1/2) A(1) B(1/2) O(1)", 1},
        {"O(1) B(1/2) A(1) B(1/2)", 1}}) {
    const auto shown_text = std::string(text);
    CAPTURE(shown_text);
    const double slope = std::log2(error(text, 320) / error(text, 640));
    CHECK(std::abs(slope - order) < 0.1);
  }
}

TEST_CASE("a bath has the number of its step and stage, however steps are grouped or resumed") {
  const scenes::Scene scene = scenes::water_cluster();
  const Scheme scheme = scheme_of("O(1/2) B(1/2) A(1) B(1/2) O(1/2)");
  std::vector<StageNumber> numbers;
  const auto record = [&](State&, double, StageNumber at) { numbers.push_back(at); };
  State state = scene.state;
  auto integrator = with_bath(scheme, scene.bodies, scenes::no_forces, record);
  integrator.advance(state, 0.001, 3);
  integrator.advance(state, 0.001, 1);
  auto resumed = with_bath(scheme, scene.bodies, scenes::no_forces, record);
  resumed.resume_from(integrator.memory());
  resumed.advance(state, 0.001, 2);
  CHECK(resumed.steps() == 6);
  REQUIRE(numbers.size() == 12);
  for (std::size_t n = 0; n < numbers.size(); ++n)
    CHECK((numbers[n] == StageNumber{n / 2, n % 2 == 0 ? 0u : 4u}));
}

TEST_CASE("a bath with random numbers resumes with the same bits at any step") {
  const scenes::Scene scene = scenes::water_cluster();
  const auto field = [&] {
    return ForceField(scene.topology, scenes::no_truncation(), scene.state.box);
  };
  for (const char* text : {baoab, "O(1/2) B(1/2) A(1) B(1/2) O(1/2)"}) {
    CAPTURE(std::string(text));
    ForceField forces = field();
    State whole = scene.state;
    auto integrator = with_bath(scheme_of(text), scene.bodies, forces, Shaking{});
    for (int n = 0; n < 6; ++n) integrator.advance(whole, 0.001);
    for (const int first : {0, 1, 4}) {
      ForceField its = field(), again = field();
      State state = scene.state;
      auto before = with_bath(scheme_of(text), scene.bodies, its, Shaking{});
      for (int n = 0; n < first; ++n) before.advance(state, 0.001);
      auto after = with_bath(scheme_of(text), scene.bodies, again, Shaking{});
      after.resume_from(before.memory());
      if (first > 0) again.resume_from(its.list_memory(state.box), state.box);
      for (int n = first; n < 6; ++n) after.advance(state, 0.001);
      state.time = whole.time;
      CHECK(equal(state, whole));
    }
  }
}

TEST_CASE("a nested scheme may have a bath in its outer one") {
  const scenes::Scene scene = scenes::water_cluster();
  NestedScheme scheme = nested_scheme_of("velocity-verlet / hoa2 x 2 within 0.2 to 0.35 nm");
  const auto advanced = [&](const NestedScheme& of, auto bath) {
    ForceField whole(scene.topology, scenes::no_truncation(), scene.state.box);
    ForceField near(scene.topology, near_settings(scenes::no_truncation(), *of.inner),
                    scene.state.box);
    State state = scene.state;
    NestedIntegrator integrator(of, scene.bodies, whole, near, 1e-4, Workers::serial(), bath);
    for (int n = 0; n < 5; ++n) integrator.advance(state, 0.002);
    CHECK(near.evaluations() == integrator.near_evaluations());
    CHECK(near.evaluations() == 5u * unsigned(of.near_evaluations()) + 1);
    CHECK(whole.evaluations() == 5u * unsigned(of.outer.force_evaluations()) + 1);
    return state;
  };
  const State without = advanced(scheme, NoBath{});
  for (const std::size_t k : {0u, 1u}) {
    NestedScheme bathed = scheme;
    bathed.outer = with_bath_before(scheme.outer, k);
    CHECK(bathed.near_evaluations() == scheme.near_evaluations());
    CHECK(equal(advanced(bathed, Idle{}), without));
    CHECK(!equal(advanced(bathed, Damping{1}), without));
  }
  scheme.inner->scheme = scheme_of(baoab);
  check_error([&] { advanced(scheme, Idle{}); }, {"has a bath"});
}

TEST_CASE("a scheme with a bath is refused where there is none") {
  const scenes::Scene scene = scenes::water_cluster();
  check_error([&] { Integrator(scheme_of(baoab), scene.bodies, scenes::no_forces); },
              {"has a bath", "leave the stages O out"});
}
