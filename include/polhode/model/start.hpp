// SPDX-License-Identifier: MIT
// Where runs begin without a file: molecules on a lattice, momenta from Maxwell's distribution.
#pragma once

#include <cstdint>

#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// The cube that gives all molecules a mass density [u/nm³].
Box cubic_box(const Topology& topology, double density);

/// Centres on a lattice as nearly cubic as the box allows, attitudes uniform at random; components
/// of a mixture are shuffled over the lattice, and the bodies of one follow it. All momenta are
/// zero.
/// @throws Error  if an edge of the box is not longer than 0
State lattice(const Topology& topology, const Box& box, std::uint64_t seed);

/// Draws all momenta anew at a temperature [K]: p_k with variance m kT, L_k in the body frame with
/// variance J_k kT. The total momentum is then removed and the rest rescaled to exactly this
/// temperature (freedoms()): a single body turns in its place.
void draw_momenta(State& state, const Topology& topology, double temperature, std::uint64_t seed);

}  // namespace polhode
