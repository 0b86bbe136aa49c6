// SPDX-License-Identifier: MIT
// Forces are the same to the last bit for any number of threads, and independent of earlier
// evaluations.
#include <doctest/doctest.h>

#include "forces/pairs/neighbours.hpp"
#include "physics/force_laws.hpp"
#include "physics/load_bits.hpp"
#include "polhode/base/workers.hpp"
#include "polhode/integrate/flows.hpp"

using namespace polhode;

namespace {

// Bodies move a little and then far, so that the list is first reused and then rebuilt.
std::vector<std::vector<std::uint64_t>> history(const scenes::Scene& scene,
                                                const ForceSettings& settings, int threads) {
  Workers workers(threads);
  ForceField forces(scene.topology, settings, scene.state.box, workers);
  State state = scene.state;
  Load load, slope;
  Vec3Column dq, dtheta;
  std::vector<std::vector<std::uint64_t>> all;
  for (const double t : {0.0, 0.001, 0.2}) {
    for (std::size_t i = 0; i < state.size(); ++i)
      state.q.set(i, scene.state.q[i] + t * scene.bodies.inverse_m[i] * scene.state.p[i]);
    forces(state, load);
    all.push_back(bits(load));
    forces(state, load);
    CHECK((bits(load) == all.back()));
    forces.forces_alone(state, load);
    all.push_back(bits(load));
    gradient_direction(state, scene.bodies, load, dq, dtheta);
    forces.directional_derivative(state, dq, dtheta, slope);
    all.push_back(bits(slope));
    forces.forces_alone(state, load);
    CHECK((bits(load) == all[all.size() - 2]));
    forces(state, load);
    CHECK((bits(load) == all[all.size() - 3]));
  }
  CHECK(forces.neighbours().rebuilds() == 2);
  return all;
}

}  // namespace

// Work is divided by the number of bodies only, and sums are added in the order of the parts.
TEST_CASE("forces, torques, energies and virial have the same bits for any number of threads") {
  const std::vector<std::vector<std::pair<std::string, std::size_t>>> systems = {
      {{"tip4p", 512}}, {{"tip4p", 3000}}, {{"co2", 150}, {"argon", 90}, {"tip4p", 300}}};
  for (const auto& parts : systems) {
    Topology topology;
    for (const auto& [name, count] : parts) topology.parts.push_back({read_molecule(name), count});
    const double edge = 0.32 * std::cbrt(double(topology.size()));
    const scenes::Scene scene = scenes::spread(topology, {edge, edge, edge}, 31);
    CAPTURE(scene.state.size());
    for (const Precision precision : {Precision::double_precision, Precision::mixed}) {
      CAPTURE(int(precision));
      ForceSettings settings{.cutoff = 0.9, .switch_from = 0.75, .skin = 0.05};
      settings.precision = precision;
      const auto alone = history(scene, settings, 1);
      for (const int threads : {2, 3, 8}) {
        CAPTURE(threads);
        CHECK((history(scene, settings, threads) == alone));
      }
    }
  }
}
