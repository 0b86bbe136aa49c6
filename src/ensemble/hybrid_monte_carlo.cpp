// SPDX-License-Identifier: MIT
#include "polhode/ensemble/hybrid_monte_carlo.hpp"

#include <array>
#include <cmath>

#include "polhode/base/error.hpp"
#include "polhode/base/units.hpp"
#include "polhode/ensemble/random_streams.hpp"
#include "polhode/math/random.hpp"
#include "polhode/measure/energy.hpp"

namespace polhode {
void HybridMonteCarloMemory::add(double change, bool accept) {
  const double weight = std::exp(-change);
  const double bounded = change < 0 ? -std::expm1(change) : std::expm1(-change) * std::exp(-change);
  weights.add(std::array{std::isfinite(weight) ? weight : 0, accept ? 1.0 : 0.0,
                         std::isnan(change) ? 0 : bounded});
  ++trajectories;
  if (accept) ++accepted;
}

void check_hybrid(const Scheme& scheme) {
  if (!scheme.palindromic())
    throw Error(
        "hybrid Monte Carlo needs a reversible scheme, but the stages of this scheme are not a "
        "palindrome; use a reversible scheme, such as \"hoa2\"");
  if (scheme.has(Flow::bath))
    throw Error(
        "hybrid Monte Carlo draws all momenta, so the scheme must not have a bath; use a scheme "
        "without stages O");
}

HybridMonteCarlo::HybridMonteCarlo(const HybridMonteCarloSettings& settings, double temperature,
                                   const Bodies& bodies, std::uint64_t seed, Workers& workers,
                                   TotalMomentum total_momentum)
    : settings_(settings),
      maxwell_{
          .kT = units::boltzmann * temperature, .seed = seed, .total_momentum = total_momentum},
      bodies_(bodies),
      workers_(workers) {}

void HybridMonteCarlo::begin(State& state, const Load& load, std::uint64_t step) {
  memory_.work += refresh_momenta(state, bodies_, maxwell_, std::sqrt(1 - settings_.refresh),
                                  stream_of(RandomUse::hybrid_momenta, {step, 0}), workers_);
  begin_ = state;
  load_ = load;
  energy_ = energy(state, load);
}

double HybridMonteCarlo::energy(const State& state, const Load& load) const {
  return energies(state, bodies_, load, workers_).total() +
         energy_of_centre(state, bodies_, maxwell_.total_momentum);
}

bool HybridMonteCarlo::end(State& state, Load& load, std::uint64_t step) {
  const double change = energy(state, load) - energy_;
  const double weight = std::exp(-change / maxwell_.kT);
  Random random(maxwell_.seed, stream_of(RandomUse::hybrid_decision, {step, 0}));
  const bool accepted = random.uniform() < weight;
  memory_.add(change / maxwell_.kT, accepted);
  if (accepted) return true;
  const double time = state.time;
  state = begin_;
  state.time = time;
  scale(state.p, -1);
  scale(state.ell, -1);
  load = load_;
  memory_.work -= change;
  return false;
}

}  // namespace polhode
