// SPDX-License-Identifier: MIT
// The shadow energy: what a second-order scheme conserves much better than the energy
// (docs/theory.md, "The shadow energy").
#pragma once

#include <optional>
#include <span>

#include "polhode/forces/force_field.hpp"
#include "polhode/integrate/error_terms.hpp"
#include "polhode/measure/fluctuation.hpp"
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

/// Summary of a trajectory in terms of its shadow energy.
struct ShadowSummary {
  double fluctuation = 0;  ///< rms [kJ/mol]
  Drift drift;             ///< [kJ/mol/ps]
  /// Factor by which a drift becomes significant sooner than from the energy: its standard error
  /// decreases with the length of the run as t^{−3/2}, so the times scale as the errors to the
  /// power 2/3.
  double sooner = 0;
};

/// Empty if there are fewer than three samples.
/// @param raw  the drift of the energy over the same time
std::optional<ShadowSummary> shadow_summary(std::span<const BracketSample> samples,
                                            const Scheme& scheme, double h, const Drift& raw);

}  // namespace polhode
