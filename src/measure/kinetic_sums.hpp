// SPDX-License-Identifier: MIT
// Result of the loops over packs, for energies().
#pragma once

namespace polhode {

/// Kinetic energies of a range of bodies [kJ/mol].
struct KineticSums {
  double translation;  ///< Σ p²/2m
  double rotation[3];  ///< Σ L_k²/2J_k
};

}  // namespace polhode
