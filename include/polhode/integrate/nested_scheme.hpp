// SPDX-License-Identifier: MIT
// Multiple time steps as data: a scheme whose drifts are steps of another scheme.
#pragma once

#include <algorithm>
#include <optional>

#include "polhode/integrate/scheme.hpp"

namespace polhode {

/// An inner scheme. Steps of the inner scheme with the near forces replace each drift of an outer
/// scheme.
struct InnerScheme {
  Scheme scheme;
  int steps = 1;           ///< steps per drift of the outer scheme
  double switch_from = 0;  ///< distance between molecules at which the switch of the near forces
                           ///< begins [nm]
  double cutoff = 0;       ///< distance beyond which the near forces are zero [nm]
};

/// A scheme with an optional inner (nested) scheme. With an inner scheme, the kicks of the outer
/// scheme use only the slow forces.
struct NestedScheme {
  Scheme outer;
  std::optional<InnerScheme> inner;

  NestedScheme(const Scheme& scheme, std::optional<InnerScheme> within = {})
      : outer(scheme), inner(within) {}

  /// The order of the nested scheme: the lower of the outer and inner orders, or 0 if either order
  /// is unknown.
  int order() const {
    return inner ? std::min(outer.order(), inner->scheme.order()) : outer.order();
  }

  bool has(Flow flow) const { return outer.has(flow) || (inner && inner->scheme.has(flow)); }
  bool has(Gradient gradient) const {
    return outer.has(gradient) || (inner && inner->scheme.has(gradient));
  }

  /// Number of near-force evaluations per outer step, in addition to the evaluations of the total
  /// forces. Outer and inner kicks at the same positions share one evaluation. The displaced
  /// positions of a finite difference need another evaluation.
  int near_evaluations() const {
    if (!inner) return 0;
    const bool shared = inner->scheme.starts_with_kick() || inner->scheme.ends_with_kick();
    const int displaced = outer.gradient_kicks() - outer.derivatives();
    return inner_steps() * inner->scheme.force_evaluations() +
           (shared ? displaced : outer.force_evaluations());
  }
  /// Evaluations of the near-force derivative per outer step: one for each exact gradient kick,
  /// outer or inner.
  int near_derivatives() const {
    return inner ? inner_steps() * inner->scheme.derivatives() + outer.derivatives() : 0;
  }
  /// Cost of near-force evaluations and their derivatives per outer step, in units of one
  /// near-force evaluation.
  double near_cost() const { return near_evaluations() + derivative_cost * near_derivatives(); }

 private:
  /// Number of inner steps in one step of the outer scheme.
  int inner_steps() const {
    const auto drifts = std::count_if(outer.stages().begin(), outer.stages().end(),
                                      [](const Stage& stage) { return stage.flow == Flow::drift; });
    return inner->steps * static_cast<int>(drifts);
  }
};

}  // namespace polhode
