// SPDX-License-Identifier: MIT
// Atoms without names, as in all binary coordinate files.
#pragma once

#include <cmath>
#include <string>

#include "binary.hpp"
#include "polhode/io/coordinates/frame.hpp"

namespace polhode {

/// Begins a frame of atoms of a single unnamed kind. The positions of the atoms are filled in
/// later.
inline void begin_unnamed(Frame& frame, const std::string& file) {
  frame.source = file;
  frame.title.clear();
  frame.kinds.assign(1, {});
  frame.atoms.clear();
  frame.has_velocities = false;
}

/// Returns a position. Throws an Error if a coordinate is not finite.
inline const Vec3<double>& finite(const Vec3<double>& r, const BinaryInput& in) {
  if (!std::isfinite(r.x) || !std::isfinite(r.y) || !std::isfinite(r.z))
    in.refuse("a coordinate or velocity is not finite");
  return r;
}

}  // namespace polhode
