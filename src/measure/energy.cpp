// SPDX-License-Identifier: MIT
#include "polhode/measure/energy.hpp"

#include <vector>

#include "base/blocks.hpp"
#include "base/instruction_set.hpp"
#include "kinetic_sums.hpp"
#include "polhode/base/units.hpp"

namespace polhode {

POLHODE_DECLARE_LOOPS(KineticSums kinetic_sums(const State&, const Bodies&, std::size_t,
                                               std::size_t);)

namespace {

constexpr std::size_t block = 2048;  // bodies per block: about 2 µs with the widest packs

}  // namespace

Energies energies(const State& state, const Bodies& bodies, const Load& load, Workers& workers) {
  const auto loop = POLHODE_CURRENT_LOOPS(kinetic_sums);
  std::vector<KineticSums> sums(blocks(state.size(), block));
  each_block(state.size(), block, workers, [&](std::size_t first, std::size_t end) {
    sums[first / block] = loop(state, bodies, first, end);
  });
  Energies e{state.time, load.van_der_waals, load.coulomb, 0, {0, 0, 0}};
  Vec3<double> P{};
  double M = 0;
  for (const KineticSums& sum : sums) {
    e.translation += sum.translation;
    P += sum.momentum, M += sum.mass;
    for (std::size_t k = 0; k < 3; ++k) e.rotation[k] += sum.rotation[k];
  }
  if (M > 0) e.translation -= norm2(P) / (2 * M);
  const Mat3<double>& w = load.virial;
  e.external = load.external;
  e.volume = state.box.volume();
  if (const double V = e.volume; V > 0)
    e.pressure = (2 * e.translation + w[0][0] + w[1][1] + w[2][2]) / (3 * V);
  return e;
}

double energy_of_centre(const State& state, const Bodies& bodies, TotalMomentum total_momentum) {
  if (total_momentum == TotalMomentum::held) return 0;
  return norm2(polhode::total_momentum(state)) / (2 * total_mass(bodies));
}

Mat3<double> pressure_tensor(const State& state, const Bodies& bodies, const Load& load) {
  Mat3<double> sum = load.virial;
  const Vec3<double> P = total_momentum(state);
  for (std::size_t k = 0; k < 3; ++k) sum[k] += -P[k] / total_mass(bodies) * P;
  for (std::size_t i = 0; i < state.size(); ++i) {
    const Vec3<double> p = state.p[i];
    for (std::size_t k = 0; k < 3; ++k) sum[k] += p[k] * bodies.inverse_m[i] * p;
  }
  for (std::size_t k = 0; k < 3; ++k) sum[k] = sum[k] / state.box.volume();
  return sum;
}

Vec3<double> total_angular_momentum(const State& state) {
  Vec3<double> sum{};
  for (std::size_t i = 0; i < state.size(); ++i)
    sum += cross(state.q[i], state.p[i]) + state.ell[i];
  return sum;
}

double temperature(double kinetic_energy, double degrees_of_freedom) {
  return degrees_of_freedom > 0 ? 2 * kinetic_energy / (degrees_of_freedom * units::boltzmann) : 0;
}

Temperatures mean_temperatures(const Energies& mean, const DegreesOfFreedom& degrees_of_freedom) {
  Temperatures t{temperature(mean.kinetic(), degrees_of_freedom.all()),
                 temperature(mean.translation, degrees_of_freedom.translation),
                 {}};
  for (std::size_t k = 0; k < 3; ++k)
    t.rotation[k] = temperature(mean.rotation[k], degrees_of_freedom.rotation[k]);
  return t;
}

}  // namespace polhode
