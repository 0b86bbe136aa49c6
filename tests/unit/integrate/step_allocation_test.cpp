// SPDX-License-Identifier: MIT
// No step allocates.
#include <doctest/doctest.h>

#include <cstdlib>
#include <string>

#include "../allocations.hpp"
#include "polhode/forces/force_field.hpp"
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

TEST_CASE("a step with forces from a mesh does not allocate") {
  const auto by_malloc = [] {
    void* volatile memory = std::malloc(3);
    std::free(memory);
  };
  CHECK(allocations_of(by_malloc) > 0);  // they are counted
  for (const Precision precision : {Precision::double_precision, Precision::mixed}) {
    CAPTURE(int(precision));
    scenes::Scene scene = scenes::lattice({{"tip4p", 64}}, 0.35, 1.6, 5);
    ForceSettings settings{.cutoff = 0.6, .switch_from = 0.5, .skin = 0.15};
    settings.truncation = Truncation::site_switch;
    settings.electrostatics = Electrostatics::pme;
    settings.precision = precision;
    settings.mesh = MeshSettings{{12, 28, 20}, 5, 5, settings.cutoff};  // all usual factors
    ForceField forces(scene.topology, settings, scene.state.box);
    Integrator integrator(scheme_of("gier4"), scene.bodies, forces);
    integrator.advance(scene.state, 1e-5);
    const std::size_t rebuilds = forces.list_rebuilds();
    CHECK(allocations_of([&] { integrator.advance(scene.state, 1e-5, 3); }) == 0);
    CHECK(forces.list_rebuilds() == rebuilds);
  }
}
