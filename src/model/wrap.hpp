// SPDX-License-Identifier: MIT
// Positions wrapped into the box.
#pragma once

#include <algorithm>
#include <cmath>

#include "polhode/model/box.hpp"

namespace polhode {

/// The periodic image of a coordinate between 0 and the edge; round-off may give exactly the edge.
inline double wrapped(double x, double edge) {
  return std::max(0.0, x - std::floor(x / edge) * edge);
}

/// The periodic image of a position [nm] in the box that begins at the origin.
inline Vec3<double> wrapped(const Vec3<double>& r, const Box& box) {
  return {wrapped(r.x, box.edge.x), wrapped(r.y, box.edge.y), wrapped(r.z, box.edge.z)};
}

}  // namespace polhode
