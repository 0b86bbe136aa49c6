// SPDX-License-Identifier: MIT
// Runs of an ensemble as a whole: thermostat, barostat and steps together.
#include <doctest/doctest.h>

#include <string>

#include "polhode/base/units.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/run/simulation/propagator.hpp"
#include "scenes.hpp"

using namespace polhode;

// Every move adds its violation of detailed balance, here a small part of kT, to the conserved
// energy, so that it exceeds the kinetic energy of 8 atoms, about 12 kT, in 16,000 moves.
TEST_CASE("a drift of the conserved energy that builds up over many samples ends no run") {
  const scenes::Scene scene = scenes::lattice({{"argon", 8}}, 1.5, 4, 1);
  System system{
      scene.topology, scene.bodies, scene.state, {.cutoff = 0.8, .switch_from = 0.7}, 300};
  const double pressure = 8 * units::boltzmann * 300 / scene.state.box.volume();
  TrajectorySettings settings{
      .scheme = scheme_of("obabo"), .step = 0.02, .length = 1600, .sample = 0.1};
  settings.ensemble = {.temperature = 300,
                       .thermostat = ThermostatSettings{},
                       .barostat = BarostatSettings{.pressure = pressure,
                                                    .time_constant = 1,
                                                    .compressibility = 1 / pressure,
                                                    .every = 0.1,
                                                    .metropolis = false}};
  ForceField forces(system.topology, system.forces, system.state.box);
  Propagator propagator(system, forces, settings);
  double last = 0;
  Watch watch;
  watch.sample = [&](std::size_t, const State&, const Energies& now) { last = now.conserved(); };
  const Trajectory result = propagator.run(watch);
  const Energies& first = result.statistics.energies.first;
  CAPTURE(last);
  CHECK(result.failure == "");
  CHECK(result.steps == 80000);
  CHECK(std::abs(last - first.conserved()) > first.kinetic());
}
