// SPDX-License-Identifier: MIT
// Hybrid Monte Carlo [duane1987]: trajectories of a scheme are proposals, which are accepted or
// rejected by their energy errors. Hybrid Monte Carlo samples the canonical distribution exactly
// with any time step.
#pragma once

#include <cstdint>

#include "polhode/base/workers.hpp"
#include "polhode/ensemble/langevin.hpp"
#include "polhode/integrate/scheme.hpp"
#include "polhode/measure/correlated_series.hpp"
#include "polhode/model/ensemble_settings.hpp"
#include "polhode/model/load.hpp"
#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// Sums that hybrid Monte Carlo has accumulated so far.
struct HybridMonteCarloMemory {
  double work = 0;  ///< energy given to the bodies by new momenta and rejections [kJ/mol]
  std::uint64_t trajectories = 0, accepted = 0;
  /// Blocks of three quantities. The first quantity is the weight w = exp(−ΔH/kT). The mean of w
  /// must be 1. The second quantity is 1 for accepted trajectories and 0 for rejected trajectories.
  /// The third quantity is (w − 1) exp(−|ΔH|/kT). The mean of the third quantity must be 0
  /// (docs/theory.md, Eq. (40)). The third quantity lies between −1 and 1, so its error is known
  /// even if rare large weights make the error of w unknown.
  TimeBlocks weights;

  /// Adds the decision on one trajectory.
  /// @param change  ΔH/kT at the end of the trajectory; infinite or NaN if the energy is not finite
  void add(double change, bool accept);
};

/// @throws Error  unless the scheme is a palindrome without a bath; other schemes are not
///   reversible. All drifts and kicks conserve phase-space volume. Gradient kicks by finite
///   difference also conserve this volume, because they change momenta by a function of positions
///   and orientations only.
void check_hybrid(const Scheme& scheme);

/// Accepts or rejects trajectories of a scheme. A trajectory begins with momenta √(1 − φ) p + √φ ξ,
/// where φ is the fraction to refresh. The momenta ξ have the Maxwell distribution with total
/// momentum 0. The end of the trajectory is accepted with probability min(1, exp(−ΔH/kT)).
/// Otherwise the bodies return to the beginning of the trajectory, with reversed momenta
/// [horowitz1991].
class HybridMonteCarlo {
 public:
  /// @param bodies, workers  kept by reference
  HybridMonteCarlo(const HybridMonteCarloSettings& settings, double temperature,
                   const Bodies& bodies, std::uint64_t seed, Workers& workers = Workers::serial(),
                   TotalMomentum total_momentum = TotalMomentum::held);

  std::size_t steps() const { return settings_.steps; }

  /// Refreshes the momenta at the start of a trajectory.
  /// @param load  load of the state, with energies
  /// @param step  number of the next step, which selects the random numbers
  void begin(State& state, const Load& load, std::uint64_t step);
  /// Accepts or rejects a trajectory at its end.
  /// @param load  load of the state, with energies; after a rejection, load of the restored state
  /// @return  whether the trajectory was accepted
  bool end(State& state, Load& load, std::uint64_t step);

  const HybridMonteCarloMemory& memory() const { return memory_; }
  void resume_from(const HybridMonteCarloMemory& memory) { memory_ = memory; }

 private:
  double energy(const State& state, const Load& load) const;

  HybridMonteCarloSettings settings_;
  LangevinSettings maxwell_;
  const Bodies& bodies_;
  Workers& workers_;
  HybridMonteCarloMemory memory_;
  State begin_;
  Load load_;
  double energy_ = 0;  // energy at the start of the trajectory [kJ/mol]
};

}  // namespace polhode
