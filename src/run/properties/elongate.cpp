// SPDX-License-Identifier: MIT
#include "run/properties/elongate.hpp"

#include <cmath>

#include "measure/finite_size.hpp"

namespace polhode {

void elongate(System& system) {
  const State one = system.state;
  Vec3<double> stack = one.box.edge;
  stack.z *= static_cast<double>(elongated_copies);
  const double volume = stack.x * stack.y * stack.z, side = std::cbrt(volume / orthoboxy_ratio);
  const Vec3<double> edge{side, side, orthoboxy_ratio * side};
  const Vec3<double> factor{edge.x / stack.x, edge.y / stack.y, edge.z / stack.z};
  State& all = system.state = State(elongated_copies * one.size(), Box{edge});
  std::size_t first = 0, to = 0;
  for (auto& [molecule, count] : system.topology.parts) {
    for (std::size_t copy = 0; copy < elongated_copies; ++copy)
      for (std::size_t i = first; i < first + count; ++i, ++to) {
        const double up = static_cast<double>(copy) * one.box.edge.z;
        all.q.set(to, scaled(factor, one.q[i] + Vec3<double>{0, 0, up}));
        all.orientation.set(to, one.orientation[i]);
      }
    first += count;
    count *= elongated_copies;
  }
  system.bodies = Bodies(system.topology);
}

}  // namespace polhode
