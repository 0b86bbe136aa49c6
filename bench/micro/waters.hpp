// SPDX-License-Identifier: MIT
// Boxes of liquid water of many sizes.
#pragma once

#include <cstddef>

#include "polhode/run/simulation/system/system.hpp"

namespace polhode::bench {

/// A system with `copies` copies of the box of 512 TIP4P waters along each edge.
inline System waters(std::size_t copies) {
  const System one = build_system(default_config());
  System all = one;
  const std::size_t n = one.state.size(), boxes = copies * copies * copies;
  all.topology.parts[0].count = n * boxes;
  all.state = State(n * boxes, Box{static_cast<double>(copies) * one.state.box.edge});
  for (std::size_t box = 0; box < boxes; ++box)
    for (std::size_t i = 0; i < n; ++i) {
      const Vec3<double> cell{static_cast<double>(box % copies),
                              static_cast<double>(box / copies % copies),
                              static_cast<double>(box / (copies * copies))};
      all.state.q.set(box * n + i, one.state.q[i] + scaled(cell, one.state.box.edge));
      all.state.orientation.set(box * n + i, one.state.orientation[i]);
    }
  return all;
}

}  // namespace polhode::bench
