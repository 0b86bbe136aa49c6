// SPDX-License-Identifier: MIT
#include "run/simulation/system/fitting_density.hpp"

#include <fmt/core.h>

#include <cmath>

#include "io/settings/quantity.hpp"
#include "model/initial_state.hpp"

namespace polhode {

std::string fitting_density(const Topology& topology, const Box& box, std::uint64_t seed,
                            const std::function<bool(const State&)>& overlaps) {
  constexpr double lower = 0.9, min_share = 0.05;
  const double density = topology.mass() / box.volume();
  for (double share = lower; share > min_share; share *= lower) {
    const Box larger{std::cbrt(1 / share) * box.edge};
    if (!overlaps(lattice(topology, larger, seed)))
      return fmt::format(
          ", or a density of {:.2g} g/cm3, at which molecules do not overlap on this lattice",
          share * density / unit("g/cm3", Dimension::density));
  }
  return {};
}

}  // namespace polhode
