// SPDX-License-Identifier: MIT
// What the smooth part of a law of charges counts too much, wherever bodies are.
#pragma once

#include "polhode/forces/smooth_polynomial.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// The smooth part is of all pairs of charges; each charge with itself and the charges of one body
/// with each other are taken off again [kJ/mol].
struct OwnCharges {
  double self = 0, intramolecular = 0;
  double net = 0;  ///< sum of all charges [e]

  OwnCharges(const Topology& topology, const SmoothPolynomial& smooth);
};

}  // namespace polhode
