// SPDX-License-Identifier: MIT
#include "polhode/ensemble/langevin.hpp"

#include <cmath>
#include <vector>

#include "base/blocks.hpp"
#include "base/instruction_set.hpp"
#include "langevin_terms.hpp"
#include "polhode/model/centre_of_mass.hpp"

namespace polhode {

POLHODE_DECLARE_LOOPS(LangevinSums langevin(State&, const Bodies&, const LangevinTerms&,
                                            std::size_t, std::size_t);)

namespace {

constexpr std::size_t block = 128;  // bodies per block, which take a few µs with the widest packs

double apply(State& state, const Bodies& bodies, const LangevinTerms& terms,
             TotalMomentum total_momentum, Workers& workers) {
  const auto loop = POLHODE_CURRENT_LOOPS(langevin);
  std::vector<LangevinSums> sums(blocks(state.size(), block));
  each_block(state.size(), block, workers, [&](std::size_t first, std::size_t end) {
    sums[first / block] = loop(state, bodies, terms, first, end);
  });
  double heat = 0, mass = 0;
  Vec3<double> momentum{};
  for (const LangevinSums& sum : sums) heat += sum.heat, momentum += sum.momentum, mass += sum.mass;
  if (total_momentum == TotalMomentum::free || terms.noise == 0) return heat;
  subtract_velocity(state, bodies, momentum / mass, workers);
  return heat - norm2(momentum) / (2 * mass);
}

}  // namespace

double ornstein_uhlenbeck(State& state, const Bodies& bodies, const LangevinSettings& s, double t,
                          std::uint64_t stream, Workers& workers) {
  if ((s.friction == 0 && s.rotational_friction == 0) || t == 0) return 0;
  // √(1 − c²), computed without cancellation for small γt
  const auto noise = [&](double gamma) { return std::sqrt(-std::expm1(-2 * gamma * t) * s.kT); };
  return apply(state, bodies,
               {std::exp(-s.friction * t), noise(s.friction), std::exp(-s.rotational_friction * t),
                noise(s.rotational_friction), s.seed, stream, s.numbers},
               s.total_momentum, workers);
}

double refresh_momenta(State& state, const Bodies& bodies, const LangevinSettings& s, double c,
                       std::uint64_t stream, Workers& workers) {
  if (c == 1) return 0;
  const double noise = std::sqrt((1 - c * c) * s.kT);
  return apply(state, bodies, {c, noise, c, noise, s.seed, stream, s.numbers}, s.total_momentum,
               workers);
}

}  // namespace polhode
