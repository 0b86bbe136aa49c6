// SPDX-License-Identifier: MIT
// Runs of an ensemble as a whole: thermostat, barostat and steps together.
#include <doctest/doctest.h>

#include <string>

#include "polhode/base/units.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/run/simulation/trajectory/propagator.hpp"
#include "scenes.hpp"

using namespace polhode;

// With a step that is long for it the scheme adds heat in all samples alike: in four runs of this
// liquid 0.06 kJ/mol per ps, 3.5 times the kinetic energy of 109 kJ/mol here, and at most 16 from
// one sample to the next.
TEST_CASE("a drift of the conserved energy that builds up over many samples ends no run") {
  const scenes::Scene scene = scenes::lattice({{"argon", 27}}, 0.5, 4, 1);
  System system{
      scene.topology, scene.bodies, scene.state, {.cutoff = 0.5, .switch_from = 0.45}, 300};
  TrajectorySettings settings{
      .scheme = scheme_of("obabo"), .step = 0.035, .length = 6300, .sample = 0.1};
  settings.ensemble = {.temperature = 300,
                       .thermostat = Langevin{.friction = 10},
                       .barostat = {},
                       .hybrid_monte_carlo = {}};
  ForceField forces(system.topology, system.forces, system.state.box);
  Propagator propagator(system, forces, settings);
  double last = 0;
  Watch watch;
  watch.sample = [&](std::size_t, const State&, const Energies& now) { last = now.conserved(); };
  const Trajectory result = propagator.run(watch);
  const Energies& first = result.statistics.energies.first;
  CAPTURE(last);
  CHECK(result.failure == "");
  CHECK(result.steps == 180000);
  CHECK(std::abs(last - first.conserved()) > first.kinetic());
}
