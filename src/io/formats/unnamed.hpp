// SPDX-License-Identifier: MIT
// What binary files of coordinates share: atoms without names.
#pragma once

#include <cmath>
#include <string>

#include "binary.hpp"
#include "polhode/io/frame.hpp"

namespace polhode {

/// Atoms of one kind without a name, with positions to be filled in.
inline void begin_unnamed(Frame& frame, const std::string& file) {
  frame.source = file;
  frame.title.clear();
  frame.kinds.assign(1, {});
  frame.atoms.clear();
  frame.has_velocities = false;
}

/// Refuses coordinates that are no numbers.
inline const Vec3<double>& finite(const Vec3<double>& r, const BinaryInput& in) {
  if (!std::isfinite(r.x) || !std::isfinite(r.y) || !std::isfinite(r.z))
    in.refuse("a coordinate or velocity is not finite; it must be a number");
  return r;
}

}  // namespace polhode
