// SPDX-License-Identifier: MIT
#include "run/simulation/system/einstein_frequency.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "polhode/base/units.hpp"

namespace polhode {

double einstein_frequency(const System& system, const State& state, Workers& workers) {
  ForceField forces(system.topology, system.forces, state.box, workers);
  Load load(system.bodies.size());
  forces(state, load);
  double max_sum = 0;
  std::size_t body = 0;
  for (const auto& part : system.topology.parts) {
    std::array<double, 4> squares{};  // squares of p/√m and L_k/√J_k, and of their time derivatives
    for (std::size_t end = body + part.count; body < end; ++body) {
      const Bodies& b = system.bodies;
      squares[0] += dot(load.f[body], load.f[body]) * b.inverse_m[body] / 3;
      const Vec3<double> tau = to_body(state.orientation[body], load.tau[body]);
      for (std::size_t k = 0; k < 3; ++k) squares[k + 1] += tau[k] * tau[k] * b.inverse_J[body][k];
    }
    for (const double sum : squares)
      max_sum = std::max(max_sum, sum / static_cast<double>(part.count));
  }
  return std::sqrt(max_sum / (units::boltzmann * system.temperature));
}

}  // namespace polhode
