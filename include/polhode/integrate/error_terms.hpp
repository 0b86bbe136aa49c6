// SPDX-License-Identifier: MIT
// The O(h²) error terms of a palindromic scheme, computed from its stages (docs/theory.md,
// Eq. (10)).
#pragma once

#include "polhode/integrate/scheme.hpp"

namespace polhode {

/// The prefactors α and β in H̃ = H + h² (α V̈ + β W) + O(h⁴), the Hamiltonian that a palindromic
/// scheme conserves. The Poisson brackets are V̈ = {T,{T,V}} and W = {V,{V,T}}.
struct ErrorTerms {
  double alpha = 0, beta = 0;
};

/// Computes the O(h²) error terms of a scheme, from the middle stage outwards. Each pair of stages
/// e^{X/2} · e^{X/2} is wrapped around the inner part by the symmetric Baker-Campbell-Hausdorff
/// formula [parisi1988]. Baths are ignored, because only drifts and kicks contribute O(h²) error
/// terms.
/// @param scheme  a palindrome; any other scheme has O(h) errors, which are not computed
constexpr ErrorTerms error_terms(const Scheme& scheme) {
  const auto stages = scheme.stages();
  double a = 0, b = 0;  // sums over the drifts and kicks so far
  ErrorTerms error;
  const std::size_t middle = stages.size() / 2;
  for (std::size_t i = middle; i < stages.size(); ++i) {
    const double t = stages[i].fraction;
    const bool pair = i > middle;
    switch (stages[i].flow) {
      case Flow::drift:
        if (pair) error.alpha -= t * b * (t + a) / 6, error.beta += t * b * b / 6;
        a += pair ? 2 * t : t;
        break;
      case Flow::kick:
        if (pair) error.alpha += t * a * a / 6, error.beta -= t * a * (t + b) / 6;
        error.beta -= (pair ? 2 * t : t) * stages[i].xi;
        b += pair ? 2 * t : t;
        break;
      case Flow::bath:  // not a part of the Hamiltonian
        break;
    }
  }
  return error;
}

}  // namespace polhode
