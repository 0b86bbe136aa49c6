// SPDX-License-Identifier: MIT
#include "polhode/measure/energy.hpp"

#include "polhode/base/units.hpp"

namespace polhode {

Energies energies(const State& state, const Bodies& bodies, const Load& load) {
  Energies e{state.time, load.lennard_jones, load.coulomb, 0, {0, 0, 0}};
  for (std::size_t i = 0; i < state.size(); ++i) {
    e.translation += norm2(state.p[i]) * bodies.inverse_m[i] / 2;
    const Vec3<double> L = to_body(state.attitude[i], state.ell[i]);
    for (std::size_t k = 0; k < 3; ++k) e.rotation[k] += L[k] * L[k] * bodies.inverse_J[i][k] / 2;
  }
  return e;
}

Vec3<double> total_momentum(const State& state) {
  Vec3<double> sum{};
  for (std::size_t i = 0; i < state.size(); ++i) sum += state.p[i];
  return sum;
}

Vec3<double> total_angular_momentum(const State& state) {
  Vec3<double> sum{};
  for (std::size_t i = 0; i < state.size(); ++i)
    sum += cross(state.q[i], state.p[i]) + state.ell[i];
  return sum;
}

Freedoms freedoms(const Topology& topology) {
  Freedoms n;
  n.translation = topology.size() > 1 ? 3 * static_cast<double>(topology.size()) - 3 : 3;
  for (const auto& part : topology.parts)
    for (std::size_t k = 0; k < 3; ++k)
      if (part.molecule.J[k] > 0) n.rotation[k] += static_cast<double>(part.count);
  return n;
}

double temperature(double kinetic_energy, double freedoms) {
  return freedoms > 0 ? 2 * kinetic_energy / (freedoms * units::boltzmann) : 0;
}

}  // namespace polhode
