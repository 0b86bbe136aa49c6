// SPDX-License-Identifier: MIT
// No step allocates.
#include <doctest/doctest.h>

#include <string>

#include "allocations.hpp"
#include "polhode/integrate/nested_integrator.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/integrate/schemes.hpp"
#include "scenes.hpp"

using namespace polhode;

namespace {

struct Spring {
  void operator()(const State& state, Load& load) const {
    for (std::size_t i = 0; i < state.size(); ++i) load.f.set(i, -100 * state.q[i]);
  }
  void directional_derivative(const State& state, const Vec3Column& dq, const Vec3Column&,
                              Load& slope) const {
    for (std::size_t i = 0; i < state.size(); ++i) slope.f.set(i, -100 * dq[i]);
  }
};

struct Idle {
  void operator()(State&, double, StageNumber) const {}
};

}  // namespace

TEST_CASE("a step does not allocate, with inner steps or a bath or without") {
  CHECK(allocations_of([] { Vec3Column(3); }) > 0);  // they are counted
  scenes::Scene scene = scenes::water_cluster();
  Spring forces, near;
  for (const Scheme& scheme : schemes) {
    CAPTURE(std::string(scheme.name()));
    Integrator integrator(scheme, scene.bodies, forces);
    NestedIntegrator nested({scheme, InnerScheme{scheme, 2}}, scene.bodies, forces, near);
    integrator.advance(scene.state, 0.001);
    nested.advance(scene.state, 0.001);
    CHECK(allocations_of([&] { integrator.advance(scene.state, 0.001, 3); }) == 0);
    CHECK(allocations_of([&] { nested.advance(scene.state, 0.001, 3); }) == 0);
  }
  Integrator bathed(scheme_of("B(1/2) A(1/2) O(1) A(1/2) B(1/2)"), scene.bodies, forces,
                    FreeDrift{scene.bodies, Workers::serial()}, Idle{});
  bathed.advance(scene.state, 0.001);
  CHECK(allocations_of([&] { bathed.advance(scene.state, 0.001, 3); }) == 0);
}
