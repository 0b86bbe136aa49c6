// SPDX-License-Identifier: MIT
// Arguments and result of the loop over packs of the Ornstein-Uhlenbeck flow.
#pragma once

#include <cstdint>

#include "polhode/base/vec3.hpp"

namespace polhode {

/// Coefficients of the Langevin bath p ← c p + noise √m ξ with noise = √((1 − c²) kT). The equation
/// for L contains √J instead of √m.
struct LangevinTerms {
  double c, noise;                        ///< coefficients of translation
  double rotational_c, rotational_noise;  ///< coefficients of rotation
  std::uint64_t seed, stream;
  const std::uint64_t* numbers;  ///< numbers of the bodies; if null, the indices of the bodies are
                                 ///< used
};

/// Sums over a range of bodies after the bath has acted.
struct LangevinSums {
  double heat;            ///< change of the kinetic energy [kJ/mol]
  Vec3<double> momentum;  ///< total momentum Σ p after the bath [u nm/ps]
  double mass;            ///< total mass Σ m [u]
};

}  // namespace polhode
