// SPDX-License-Identifier: MIT
// Self-energy and exclusion corrections of the smooth part of the electrostatics, which do not
// depend on the positions of bodies.
#pragma once

#include "forces/laws/smooth_polynomial.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// Self-energy and intramolecular (exclusion) corrections [kJ/mol]. The smooth part is summed over
/// all pairs of charges, so the self-interaction of each charge and the interactions within a body
/// are subtracted.
struct SelfInteraction {
  double self = 0, intramolecular = 0;
  double net = 0;  ///< sum of all charges [e]

  SelfInteraction(const Topology& topology, const SmoothPolynomial& smooth);
};

}  // namespace polhode
