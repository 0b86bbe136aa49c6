// SPDX-License-Identifier: MIT
// 64 SPC/E waters at 500 K, which relax in half a picosecond.
#pragma once

#include <cmath>

#include "polhode/run/simulation/system/system.hpp"
#include "scenes.hpp"

namespace polhode::scenes {

inline constexpr double hot = 500;  // [K]

/// At 0.95 g/cm³, with a lattice of random orientations.
inline System hot_water(unsigned seed, Precision precision = Precision::mixed) {
  const double box = std::cbrt(64 * 18.0154 * 1.66053906660e-3 / 0.95);
  const Scene scene = lattice({{"spce", 64}}, box / 4, box, seed);
  return {scene.topology,
          scene.bodies,
          scene.state,
          {.cutoff = 0.56,
           .switch_from = 0.48,
           .electrostatics = Electrostatics::reaction_field,
           .precision = precision},
          hot};
}

}  // namespace polhode::scenes
