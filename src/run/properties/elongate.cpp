// SPDX-License-Identifier: MIT
#include "run/properties/elongate.hpp"

#include <cmath>

#include "measure/finite_size.hpp"

namespace polhode {

void stack(System& system, std::size_t copies) {
  const State one = system.state;
  Box box = one.box;
  box.edge.z *= static_cast<double>(copies);
  State& all = system.state = State(copies * one.size(), box);
  std::size_t first = 0, to = 0;
  for (auto& [molecule, count] : system.topology.parts) {
    for (std::size_t copy = 0; copy < copies; ++copy)
      for (std::size_t i = first; i < first + count; ++i, ++to) {
        const double up = static_cast<double>(copy) * one.box.edge.z;
        all.q.set(to, one.q[i] + Vec3<double>{0, 0, up});
        all.orientation.set(to, one.orientation[i]);
      }
    first += count;
    count *= copies;
  }
  system.bodies = Bodies(system.topology);
}

void elongate(System& system) {
  stack(system, elongated_copies);
  State& state = system.state;
  const Vec3<double> before = state.box.edge;
  const double side = std::cbrt(state.box.volume() / orthoboxy_ratio);
  const Vec3<double> edge{side, side, orthoboxy_ratio * side};
  const Vec3<double> factor{edge.x / before.x, edge.y / before.y, edge.z / before.z};
  for (std::size_t i = 0; i < state.size(); ++i) state.q.set(i, scaled(factor, state.q[i]));
  state.box = Box{edge};
}

}  // namespace polhode
