// SPDX-License-Identifier: MIT
// Extended XYZ, as ASE and OVITO read it: Lattice, Properties and Time in the comment line,
// positions in Å.
#pragma once

#include <iosfwd>

#include "polhode/io/frame.hpp"

namespace polhode {

/// Appends a frame. Positions are in Å, the time in ps and velocities, if the frame has any, in
/// Å/ps. Massless sites, if the frame has them, are of species X.
void write_xyz(std::ostream& out, const Frame& frame);

/// Appends the frame of a state, without holding it whole.
void write_xyz(std::ostream& out, const State& state, const Topology& topology);

}  // namespace polhode
