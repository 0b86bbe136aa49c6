// SPDX-License-Identifier: MIT
// Finds a density at which the molecules of a lattice do not overlap.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// Advice about a lattice with overlapping molecules, such as ", or a density of 0.79 g/cm3, at
/// which this lattice fits". Lattices with the same seed are tried in larger boxes of the same
/// shape, with densities that decrease by 10 % each. The text is empty if molecules overlap at all
/// densities down to 5 % of the original density.
std::string fitting_density(const Topology& topology, const Box& box, std::uint64_t seed,
                            const std::function<bool(const State&)>& overlaps);

}  // namespace polhode
