// SPDX-License-Identifier: MIT
#include "polhode/model/degrees_of_freedom.hpp"

#include <algorithm>

namespace polhode {

DegreesOfFreedom degrees_of_freedom(const Topology& topology, TotalMomentum total_momentum) {
  DegreesOfFreedom n;
  const double held = total_momentum == TotalMomentum::held ? 3 : 0;
  n.translation = std::max(0.0, 3 * static_cast<double>(topology.size()) - held);
  for (const auto& part : topology.parts)
    for (std::size_t k = 0; k < 3; ++k)
      if (part.molecule.J[k] > 0) n.rotation[k] += static_cast<double>(part.count);
  return n;
}

}  // namespace polhode
