// SPDX-License-Identifier: MIT
// A scheme as a sequence of force evaluations, for engines that determine when forces are computed.
// Such engines call the integrator before and after each evaluation.
#pragma once

#include <cstddef>
#include <vector>

#include "polhode/base/error.hpp"
#include "polhode/integrate/scheme.hpp"

namespace polhode {

/// One force evaluation of a step, and the stages of the scheme before and after the evaluation.
struct ForceEvaluation {
  std::size_t first = 0;  ///< Stages k with first ≤ k < use lead to the positions of this
                          ///< evaluation. Kicks among these stages use the forces of the preceding
                          ///< plain evaluation.
  std::size_t use = 0;    ///< stages use ≤ k < end change momenta with the forces of this
                          ///< evaluation
  std::size_t end = 0;
  double xi = 0;  ///< ξ of a gradient kick by finite difference, where stage `use` is the kick. The
                  ///< forces belong to positions displaced as in [vanzon2008, Eq. 7], which are
                  ///< restored afterwards. For a plain evaluation, ξ is 0.
};

/// Lists the force evaluations of one step in order. At the initial positions of a step, the forces
/// of the last evaluation of the previous step are used. A scheme that begins with a kick has as
/// many evaluations as Scheme::force_evaluations() counts. Any other scheme needs one more
/// evaluation.
/// @throws Error  if the scheme has exact gradients, because other engines do not compute
///   derivatives of forces
inline std::vector<ForceEvaluation> force_program(const Scheme& scheme) {
  if (scheme.has(Gradient::exact))
    throw Error(
        "the scheme has exact gradient kicks, which need the derivative of the forces; use finite "
        "differences, as in \"gier4-fd\"");
  const auto stages = scheme.stages();
  std::vector<ForceEvaluation> program;
  bool known = true;      // whether the forces at the current positions are known
  std::size_t first = 0;  // first stage that does not belong to an evaluation yet
  for (std::size_t k = 0; k < stages.size(); ++k) {
    if (stages[k].flow == Flow::drift) {
      known = false;
      continue;
    }
    const bool kick = stages[k].flow == Flow::kick;
    if (kick && !known) {
      program.push_back({first, k, k});
      known = true, first = k;
    }
    if (kick && stages[k].xi != 0) {
      program.push_back({first, k, k, stages[k].xi});
      first = k;
    }
    if (known && !program.empty()) program.back().end = first = k + 1;
  }
  if (!known) program.push_back({first, stages.size(), stages.size()});
  return program;
}

}  // namespace polhode
