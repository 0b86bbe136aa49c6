// SPDX-License-Identifier: MIT
// Hybrid Monte Carlo [duane1987]: trajectories of a scheme as proposals, accepted or rejected by
// their energy error, so that the canonical distribution is sampled exactly with any step.
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

/// What hybrid Monte Carlo has done so far.
struct HybridMonteCarloMemory {
  double work = 0;  ///< energy that the bodies received from draws and rejections [kJ/mol]
  std::uint64_t trajectories = 0, accepted = 0;
  /// Blocks of three quantities: w = exp(−ΔH/kT), whose mean must be 1; 1 if accepted and 0 if not;
  /// (w − 1) exp(−|ΔH|/kT), whose mean must be 0 (docs/theory.md, Eq. (40)). The last is between −1
  /// and 1, so its error is known even if rare large weights make the error of w unknown.
  TimeBlocks weights;

  /// Adds a trajectory.
  /// @param change  ΔH/kT at its end; infinite or not a number where the energy is none
  void add(double change, bool accept);
};

/// @throws Error  unless the scheme is a palindrome, so that it is reversible, without a bath.
///                Drifts and kicks keep volume in phase space, gradient kicks by finite difference
///                included: each changes momenta by a function of positions and orientations
void check_hybrid(const Scheme& scheme);

/// The decisions between trajectories of a scheme. A trajectory begins with momenta √(1 − φ) p + √φ
/// ξ, with ξ from the Maxwell distribution of total momentum 0, and φ the part to refresh. Its end
/// is accepted with probability min(1, exp(−ΔH/kT)). Otherwise the bodies return to its begin, with
/// opposite momenta [horowitz1991].
class HybridMonteCarlo {
 public:
  /// @param bodies, workers  kept by reference
  HybridMonteCarlo(const HybridMonteCarloSettings& settings, double temperature,
                   const Bodies& bodies, std::uint64_t seed, Workers& workers = Workers::serial(),
                   TotalMomentum total_momentum = TotalMomentum::held);

  std::size_t steps() const { return settings_.steps; }

  /// Refreshes the momenta.
  /// @param load  of the state, with energies
  /// @param step  the number of the next step, for the random numbers
  void begin(State& state, const Load& load, std::uint64_t step);
  /// Decides at the end of a trajectory.
  /// @param load  of the state, with energies; after a rejection, of the first state
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
  double energy_ = 0;  // at the begin [kJ/mol]
};

}  // namespace polhode
