// SPDX-License-Identifier: MIT
// Detects initial configurations with overlapping molecules.
#pragma once

#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// The smallest allowed distance between sites of different molecules [nm], for sites with mass or
/// Lennard-Jones parameters. The smallest allowed distance is half the length of a hydrogen bond
/// (0.17 nm), which is the shortest contact in liquids.
inline constexpr double closest_contact = 0.085;

/// Checks that no two molecules overlap.
/// @throws Error  if sites of two molecules are too close; the message names the first pair in the
///   order of sites
void check_overlap(const Topology& topology, const State& state);

}  // namespace polhode
