// SPDX-License-Identifier: MIT
// Self-energy and exclusion corrections of the smooth part of the electrostatics, which do not
// depend on the positions of bodies.
#pragma once

#include "forces/laws/smooth_polynomial.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// The smooth part is summed over all pairs of charges, so the self-interaction of each charge and
/// the interaction of charges within the same body are subtracted again [kJ/mol].
struct SelfInteraction {
  double self = 0, intramolecular = 0;
  double net = 0;  ///< sum of all charges [e]

  SelfInteraction(const Topology& topology, const SmoothPolynomial& smooth);
};

}  // namespace polhode
