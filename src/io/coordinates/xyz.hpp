// SPDX-License-Identifier: MIT
// Extended XYZ in the dialect of ASE and OVITO: Lattice, Properties and Time in the comment line,
// positions in Å.
#pragma once

#include <iosfwd>

#include "polhode/io/coordinates/frame.hpp"

namespace polhode {

/// Appends a frame. Positions are in Å, the time in ps and velocities, if any, in Å/ps. Massless
/// sites, if any, have the species X.
void write_xyz(std::ostream& out, const Frame& frame);

/// Appends the frame of a state atom by atom.
void write_xyz(std::ostream& out, const State& state, const Topology& topology);

}  // namespace polhode
