// SPDX-License-Identifier: MIT
// Arguments and result of the loop over packs of the Ornstein-Uhlenbeck flow.
#pragma once

#include <cstdint>

#include "polhode/base/vec3.hpp"

namespace polhode {

/// p ← c p + noise √m ξ, and the same for L with √J: noise = √((1 − c²) kT).
struct LangevinTerms {
  double c, noise;                        ///< of translation
  double rotational_c, rotational_noise;  ///< of rotation
  std::uint64_t seed, stream;
  const std::uint64_t* numbers;  ///< of the bodies; null: their indices
};

/// What a range of bodies received.
struct LangevinSums {
  double heat;            ///< change of kinetic energy [kJ/mol]
  Vec3<double> momentum;  ///< Σ p afterwards [u nm/ps]
  double mass;            ///< Σ m [u]
};

}  // namespace polhode
