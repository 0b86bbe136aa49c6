// SPDX-License-Identifier: MIT
// Simulations of a slab of the liquid between its vapour, with two surfaces normal to z.
#pragma once

#include "polhode/run/simulation/system/system.hpp"
#include "run/properties/replica.hpp"

namespace polhode {

/// The number of copies of the liquid in a slab, one above the other. The vapour is as thick.
inline constexpr std::size_t slab_copies = 2;

/// Makes a slab of copies of a liquid. The uniform dispersion correction becomes slab_dispersion.
void make_slab(System& system);

/// Adds a segment of a slab. The first segment begins with the relaxed liquid at its mean volume.
/// @return  false if it was stopped; the replica is then unchanged
/// @throws RunError  if the system blows up, or the slab evaporates
bool add_slab(Replica& replica, const ReplicaSettings& settings);

/// The height of a bin of the profile [nm].
inline double height_of_bin(const State& state) {
  return state.box.edge.z / 2 / static_cast<double>(bins_of_profile);
}

}  // namespace polhode
