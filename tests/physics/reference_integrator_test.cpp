// SPDX-License-Identifier: MIT
// The integrator, with joined flows and loops over packs, against the same schemes body by body.
#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include "polhode/forces/force_field.hpp"
#include "polhode/integrate/body_flows.hpp"
#include "polhode/integrate/integrator.hpp"
#include "polhode/integrate/schemes.hpp"
#include "scenes.hpp"

using namespace polhode;

namespace {

std::vector<RigidBody> bodies_of(const scenes::Scene& scene) {
  std::vector<RigidBody> bodies;
  for (std::size_t i = 0; i < scene.state.size(); ++i)
    bodies.push_back({.m = scene.bodies.m[i],
                      .J = scene.bodies.J[i],
                      .q = scene.state.q[i],
                      .p = scene.state.p[i],
                      .orientation = scene.state.orientation[i],
                      .ell = scene.state.ell[i]});
  return bodies;
}

/// A force field as BodyFlows call it.
auto forces_of(const scenes::Scene& scene, ForceField& field) {
  return [&field, state = scene.state, load = Load(scene.state.size())](
             std::span<const RigidBody> bodies, std::span<BodyLoad> loads) mutable {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      state.q.set(i, bodies[i].q);
      state.orientation.set(i, bodies[i].orientation);
    }
    field(state, load);
    for (std::size_t i = 0; i < loads.size(); ++i) loads[i] = {load.f[i], load.tau[i]};
  };
}

/// The largest difference of a kind of coordinate, relative to the largest coordinate.
double difference(const State& state, const std::vector<RigidBody>& bodies, auto of_state,
                  auto of_body) {
  double largest = 0, off = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    largest = std::max(largest, norm(of_body(bodies[i])));
    off = std::max(off, norm(of_state(state, i) - of_body(bodies[i])));
  }
  return off / largest;
}

}  // namespace

// Both compute the same numbers in another order, and so differ by rounding: some hundred
// operations with eps each in ten steps, which the dynamics hardly amplifies. A gradient by finite
// difference divides the rounding of the forces by lambda.
TEST_CASE("the integrator is the schemes of the paper, body by body") {
  constexpr double h = 0.001, lambda = 0.01, eps = std::numeric_limits<double>::epsilon();
  const scenes::Scene scene = scenes::lattice({{"tip4p", 20}, {"n2", 7}}, 0.35, 1.05, 5);
  const ForceSettings settings{.cutoff = 0.5, .switch_from = 0.42};
  for (const Scheme& scheme : schemes) {
    if (scheme.has(Flow::bath) || scheme.has(Gradient::exact)) continue;
    CAPTURE(scheme.name());
    ForceField fast(scene.topology, settings, scene.state.box);
    ForceField slow(scene.topology, settings, scene.state.box);
    State state = scene.state;
    Integrator integrator(scheme, scene.bodies, fast, lambda);
    integrator.advance(state, h, 10);
    std::vector<RigidBody> bodies = bodies_of(scene);
    BodyFlows flows(bodies, forces_of(scene, slow), lambda);
    for (int n = 0; n < 10; ++n) step(scheme, flows, h);

    const double bound = 1000 * eps / (scheme.has(Gradient::finite_difference) ? lambda : 1);
    const auto check = [&](auto of_state, auto of_body) {
      CHECK(difference(state, bodies, of_state, of_body) < bound);
    };
    check([](const State& s, auto i) { return s.q[i]; }, [](const RigidBody& b) { return b.q; });
    check([](const State& s, auto i) { return s.p[i]; }, [](const RigidBody& b) { return b.p; });
    check([](const State& s, auto i) { return s.ell[i]; },
          [](const RigidBody& b) { return b.ell; });
    check(
        [](const State& s, auto i) {
          return to_lab(s.orientation[i], Vec3<double>{1, 2, 3});
        },
        [](const RigidBody& b) {
          return to_lab(b.orientation, Vec3<double>{1, 2, 3});
        });
    CHECK(flows.evaluations() >= static_cast<int>(integrator.force_evaluations()));
  }
}
