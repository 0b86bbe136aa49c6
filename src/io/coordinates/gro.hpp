// SPDX-License-Identifier: MIT
// GRO files, as GROMACS reads and writes them: positions [nm] and velocities [nm/ps] in columns.
// The distance between two decimal points is the width of a column.
#pragma once

#include <iosfwd>
#include <string>
#include <string_view>

#include "polhode/io/coordinates/frame.hpp"

namespace polhode {

/// Parses the first frame of a GRO file; `file` is the file name in error messages.
/// @throws Error  with file, line, the text found and the text expected
Frame parse_gro(std::string_view text, const std::string& file);

/// Writes a frame. Positions have `decimals` decimals, and velocities have `decimals` + 1 decimals,
/// as in GROMACS.
void write_gro(std::ostream& out, const Frame& frame, int decimals = 10);

/// Writes the frame of a state atom by atom.
void write_gro(std::ostream& out, const State& state, const Topology& topology, int decimals = 10);

}  // namespace polhode
