// SPDX-License-Identifier: MIT
// The shadow energy: what a scheme of second order keeps where it does not keep the energy
// (docs/theory.md, "The shadow energy").
#pragma once

#include <optional>
#include <span>

#include "polhode/forces/force_field.hpp"
#include "polhode/integrate/error_terms.hpp"
#include "polhode/measure/fluctuation.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// The two brackets of T and V that the O(h²) error of every scheme is made of [kJ/mol/ps²].
struct ErrorBrackets {
  double second_derivative = 0;  ///< V̈ = {T,{T,V}}: of V, along free flight and free rotation
  double W = 0;                  ///< {V,{V,T}}
};

/// Both brackets of a state with the Load at its positions. Costs one directional derivative of the
/// forces, along the velocities.
ErrorBrackets error_brackets(const State& state, const Bodies& bodies, const Load& load,
                             ForceField& forces);

/// The energies of a state with the brackets there.
struct BracketSample {
  Energies energies;
  ErrorBrackets brackets;
};

/// H̃ = H + h² (α V̈ + β W) [kJ/mol], which the scheme keeps to O(h⁴).
inline double shadow_energy(const BracketSample& sample, const ErrorTerms& terms, double h) {
  return sample.energies.total() +
         h * h * (terms.alpha * sample.brackets.second_derivative + terms.beta * sample.brackets.W);
}

/// A trajectory by its shadow energy.
struct ShadowSummary {
  double fluctuation = 0;  ///< rms [kJ/mol]
  Drift drift;             ///< [kJ/mol/ps]
  /// How many times sooner a drift becomes significant than by the energy: its standard error
  /// falls with the length of a run as t^{−3/2}, so the times go as the errors to the power 2/3.
  double sooner = 0;
};

/// Nothing if there are fewer than three samples.
/// @param raw  the drift of the energy over the same time
std::optional<ShadowSummary> shadow_summary(std::span<const BracketSample> samples,
                                            const Scheme& scheme, double h, const Drift& raw);

}  // namespace polhode
