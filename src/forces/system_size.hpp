// SPDX-License-Identifier: MIT
// Limits on the size of a system.
#pragma once

#include "polhode/model/box.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// Checks the number of molecules.
/// @throws Error  if there are more molecules than the neighbour list can number
void check_count(const Topology& topology);

/// Checks the lengths of the box edges.
/// @throws Error  if an edge is so long that positions in fixed point are too coarse
void check_edges(const Box& box);

}  // namespace polhode
