// SPDX-License-Identifier: MIT
// The periodic box: orthorhombic, with its edges along the lab axes.
#pragma once

#include <algorithm>
#include <cmath>

#include "polhode/base/vec3.hpp"

namespace polhode {

struct Box {
  Vec3<double> edge;  ///< box edges [nm]

  friend bool operator==(const Box&, const Box&) = default;
  double volume() const { return edge.x * edge.y * edge.z; }
  double shortest_edge() const { return std::min({edge.x, edge.y, edge.z}); }

  /// The number of whole box edges between r and its image nearest to the origin.
  Vec3<double> images(const Vec3<double>& r) const {
    return {std::nearbyint(r.x / edge.x), std::nearbyint(r.y / edge.y),
            std::nearbyint(r.z / edge.z)};
  }
  /// The periodic image of a difference vector that is nearest to zero.
  Vec3<double> minimum_image(const Vec3<double>& r) const { return r - scaled(images(r), edge); }
};

}  // namespace polhode
