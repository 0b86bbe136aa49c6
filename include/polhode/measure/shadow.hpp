// SPDX-License-Identifier: MIT
// The shadow energy: what a second-order scheme conserves much better than the energy
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

/// The two brackets of T and V that make up the O(h²) error of every scheme [kJ/mol/ps²].
struct ErrorBrackets {
  double second_derivative = 0;  ///< V̈ = {T,{T,V}}: of V, along free flight and free rotation
  double W = 0;                  ///< {V,{V,T}}
};

/// Both brackets of a state, given the Load at its positions. Costs one directional derivative of
/// the forces, along the velocities.
ErrorBrackets error_brackets(const State& state, const Bodies& bodies, const Load& load,
                             ForceField& forces);

/// The energies of a state with its brackets.
struct BracketSample {
  Energies energies;
  ErrorBrackets brackets;
};

/// H̃ = H + h² (α V̈ + β W) [kJ/mol], which the scheme conserves up to O(h⁴).
inline double shadow_energy(const BracketSample& sample, const ErrorTerms& terms, double h) {
  return sample.energies.total() +
         h * h * (terms.alpha * sample.brackets.second_derivative + terms.beta * sample.brackets.W);
}

/// Sums over the shadow energies of a trajectory, in blocks of time, relative to the first.
struct ShadowStatistics {
  std::uint64_t samples = 0;
  double first = 0, start = 0;  ///< [kJ/mol], [ps]
  TimeBlocks blocks;

  void add(double time, double shadow);
  SeriesEstimate fluctuation() const;  ///< rms deviation from the mean [kJ/mol]
  /// [kJ/mol/ps] Tested against a random walk of unknown strength, by
  /// rounding and by the remaining discontinuities of the forces
  /// (docs/statistics.md).
  Drift drift() const;
  /// The strength of that walk [(kJ/mol)²/ps], which the energy also performs. Empty if there are
  /// too few samples.
  std::vector<WalkStrength> walks() const;
};

/// Results from the shadow energy of a trajectory.
struct ShadowSummary {
  std::uint64_t samples = 0;
  SeriesEstimate fluctuation;  ///< rms [kJ/mol]
  Drift drift;                 ///< [kJ/mol/ps]
  /// How many times sooner an energy drift becomes significant than in the energy. Standard errors
  /// fall with the length of a run as t^{−3/2}, so the times are proportional to the errors to the
  /// power 2/3. Empty if one of the errors is not known.
  std::optional<double> time_gain;
};

/// Results from the statistics; empty with fewer than three samples.
/// @param raw   the energy drift over the same time
std::optional<ShadowSummary> shadow_summary(const ShadowStatistics& statistics, const Drift& raw);

}  // namespace polhode
