// SPDX-License-Identifier: MIT
// Starts in which molecules sit inside each other.
#pragma once

#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// The closest that sites with mass or Lennard-Jones of two molecules may be [nm]: half of the
/// shortest contact in liquids, that of a hydrogen bond (0.17 nm).
inline constexpr double closest_contact = 0.085;

/// @throws Error  naming two molecules if any are closer than that, the first in the order of sites
void check_overlap(const Topology& topology, const State& state);

}  // namespace polhode
