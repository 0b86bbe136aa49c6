// SPDX-License-Identifier: MIT
// At which density the molecules of a lattice no longer overlap.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// ", or a density of 0.79 g/cm3, at which this lattice fits": advice about a lattice in a box
/// whose molecules overlap. Lattices of the same seed are tried in larger boxes of the same shape,
/// at densities that fall by a tenth each; empty if all overlap down to a twentieth of the density.
std::string fitting_density(const Topology& topology, const Box& box, std::uint64_t seed,
                            const std::function<bool(const State&)>& overlaps);

}  // namespace polhode
