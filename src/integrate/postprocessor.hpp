// SPDX-License-Identifier: MIT
// Postprocessors: stages that act on a copy of a state before the state is read. The trajectory
// stays the same, but the energies and configurations that are read have smaller errors.
#pragma once

#include "polhode/integrate/error_terms.hpp"
#include "polhode/integrate/scheme.hpp"

namespace polhode {

/// A postprocessor P of a scheme K. P K P⁻¹ is closer to the exact flow than K is [blanes2004]. A
/// trajectory of K that is read through P is a trajectory of P K P⁻¹ (docs/theory.md, Eq. (56)).
struct Postprocessor {
  /// c in ln P = c h² [A, B] + O(h⁴).
  double commutator;
  /// The stages of P. The fractions of each flow sum to zero.
  Scheme stages;

  /// The prefactors of the O(h²) error of P K P⁻¹, given the prefactors of K.
  constexpr ErrorTerms error_terms(ErrorTerms scheme) const {
    return {scheme.alpha + commutator, scheme.beta - commutator};
  }
};

/// The postprocessor of a scheme; null if none is known.
const Postprocessor* postprocessor_of(const Scheme& scheme);

}  // namespace polhode
