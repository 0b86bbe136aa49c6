// SPDX-License-Identifier: MIT
// The shadow energy, which a second-order scheme conserves much better than the energy
// (docs/theory.md, Eqs. (7) and (42)).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "polhode/forces/force_field.hpp"
#include "polhode/integrate/error_terms.hpp"
#include "polhode/measure/energy.hpp"
#include "polhode/measure/slope.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// The two Poisson brackets of T and V in the O(h²) error of every scheme [kJ/mol/ps²].
struct ErrorBrackets {
  double second_derivative = 0;  ///< V̈ = {T,{T,V}}: second derivative of V along free flight and
                                 ///< free rotation
  double W = 0;                  ///< W = {V,{V,T}}
};

/// Computes both brackets of a state, given the Load at its positions. The cost is one directional
/// derivative of the forces, along the velocities.
ErrorBrackets error_brackets(const State& state, const Bodies& bodies, const Load& load,
                             ForceField& forces);

/// The energies of a state with its error brackets.
struct BracketSample {
  Energies energies;
  ErrorBrackets brackets;
};

/// The shadow energy H̃ = H + h² (α V̈ + β W) [kJ/mol], which the scheme conserves up to O(h⁴).
inline double shadow_energy(const BracketSample& sample, const ErrorTerms& terms, double h) {
  return sample.energies.total() +
         h * h * (terms.alpha * sample.brackets.second_derivative + terms.beta * sample.brackets.W);
}

/// Sums over the shadow energies of a trajectory, in blocks of time, relative to the first sample.
struct ShadowStatistics {
  std::uint64_t samples = 0;
  double first = 0, start = 0;  ///< first shadow energy [kJ/mol] and its time [ps]
  TimeBlocks blocks;

  void add(double time, double shadow);
  SeriesEstimate fluctuation() const;  ///< rms deviation of the shadow energy [kJ/mol]
  /// The drift of the shadow energy [kJ/mol/ps]. The drift is tested against a random walk of
  /// unknown strength. This random walk is caused by round-off and by the remaining discontinuities
  /// of the forces (docs/statistics.md).
  Drift drift() const;
  /// The possible strengths of the random walk that both the shadow energy and the energy perform
  /// [(kJ/mol)²/ps]. Empty if there are too few samples.
  std::vector<WalkStrength> walks() const;
};

/// Results from the shadow energy of a trajectory.
struct ShadowSummary {
  std::uint64_t samples = 0;
  SeriesEstimate fluctuation;  ///< rms deviation of the shadow energy [kJ/mol]
  Drift drift;                 ///< drift of the shadow energy [kJ/mol/ps]
  /// The factor by which the shadow energy shortens the time until an energy drift is significant.
  /// Standard errors fall with the length of a run as t^{−3/2}, so the times are proportional to
  /// the errors to the power 2/3. The result is empty if any of the standard errors is not known.
  std::optional<double> time_gain;
};

/// Summarizes the shadow energies of a trajectory; empty with fewer than three samples.
/// @param raw   energy drift over the same time
std::optional<ShadowSummary> shadow_summary(const ShadowStatistics& statistics, const Drift& raw);

}  // namespace polhode
