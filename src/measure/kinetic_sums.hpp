// SPDX-License-Identifier: MIT
// The sums over packs of bodies from which energies() computes its result.
#pragma once

#include "polhode/base/vec3.hpp"

namespace polhode {

/// Kinetic energies [kJ/mol], momentum and mass of a range of bodies.
struct KineticSums {
  double translation;     ///< kinetic energy of translation Σ p²/2m
  double rotation[3];     ///< kinetic energies of rotation Σ L_k²/2J_k
  Vec3<double> momentum;  ///< momentum Σ p [u nm/ps]
  double mass;            ///< mass Σ m [u]
};

}  // namespace polhode
