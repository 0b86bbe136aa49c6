// SPDX-License-Identifier: MIT
// Initial configurations without a file: molecules on a lattice, momenta from a Maxwell
// distribution.
#pragma once

#include <cstdint>

#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// The cubic box in which all molecules have a given mass density [u/nm³].
Box cubic_box(const Topology& topology, double density);

/// Places centres on a lattice that is as nearly cubic as the box allows, with uniformly random
/// orientations. The components of a mixture are distributed randomly over the lattice; the bodies
/// of each component are numbered in lattice order. All momenta are zero.
/// @throws Error  if an edge of the box is not positive
State lattice(const Topology& topology, const Box& box, std::uint64_t seed);

/// Draws new momenta at a temperature [K]: p_k with variance m kT, and L_k in the body frame with
/// variance J_k kT. The total momentum is then removed, and the momenta are rescaled to exactly the
/// given temperature. The temperature is computed with 3 N − 3 translational degrees of freedom
/// (none for a single body) and all rotational degrees of freedom.
void draw_momenta(State& state, const Topology& topology, double temperature, std::uint64_t seed);

}  // namespace polhode
