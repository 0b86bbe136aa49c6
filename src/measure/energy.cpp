// SPDX-License-Identifier: MIT
#include "polhode/measure/energy.hpp"

#include <vector>

#include "kinetic_sums.hpp"
#include "polhode/base/blocks.hpp"
#include "polhode/base/target.hpp"
#include "polhode/base/units.hpp"

namespace polhode {

POLHODE_DECLARE_LOOPS(KineticSums kinetic_sums(const State&, const Bodies&, std::size_t,
                                               std::size_t);)

namespace {

constexpr std::size_t block = 2048;  // bodies: about 2 µs with the widest packs

}  // namespace

Energies energies(const State& state, const Bodies& bodies, const Load& load, Workers& workers) {
  const auto loop = POLHODE_CURRENT_LOOPS(kinetic_sums);
  std::vector<KineticSums> sums(blocks(state.size(), block));
  each_block(state.size(), block, workers, [&](std::size_t first, std::size_t end) {
    sums[first / block] = loop(state, bodies, first, end);
  });
  Energies e{state.time, load.lennard_jones, load.coulomb, 0, {0, 0, 0}};
  for (const KineticSums& sum : sums) {
    e.translation += sum.translation;
    for (std::size_t k = 0; k < 3; ++k) e.rotation[k] += sum.rotation[k];
  }
  const Mat3<double>& w = load.virial;
  if (const double V = state.box.volume(); V > 0)
    e.pressure = (2 * e.translation + w[0][0] + w[1][1] + w[2][2]) / (3 * V);
  return e;
}

Mat3<double> pressure_tensor(const State& state, const Bodies& bodies, const Load& load) {
  Mat3<double> sum = load.virial;
  for (std::size_t i = 0; i < state.size(); ++i) {
    const Vec3<double> p = state.p[i];
    for (std::size_t k = 0; k < 3; ++k) sum[k] += p[k] * bodies.inverse_m[i] * p;
  }
  for (std::size_t k = 0; k < 3; ++k) sum[k] = sum[k] / state.box.volume();
  return sum;
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

Temperatures mean_temperatures(const Energies& mean, const Freedoms& freedoms) {
  Temperatures t{temperature(mean.kinetic(), freedoms.all()),
                 temperature(mean.translation, freedoms.translation),
                 {}};
  for (std::size_t k = 0; k < 3; ++k)
    t.rotation[k] = temperature(mean.rotation[k], freedoms.rotation[k]);
  return t;
}

}  // namespace polhode
