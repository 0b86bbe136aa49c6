// SPDX-License-Identifier: MIT
// Points from their distances: the shape that constraints hold a molecule in.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "polhode/base/vec3.hpp"

namespace polhode {

/// A distance that is given between two points.
struct Distance {
  std::size_t first, second;  ///< indices of points
  double length;              ///< [nm]
};

/// Distances of files are rounded: five decimals are usual [nm].
inline constexpr double distance_rounding = 1e-5;
/// So far may more distances than are needed contradict each other [nm].
inline constexpr double distance_tolerance = 1e-4;

struct PlacedPoints {
  std::vector<Vec3<double>> points;  ///< the first in the origin, the second on the x axis
  int dimension = 0;                 ///< 0 to 3; in 3 the mirror image has the same distances
};

/// The places that distances give, unique but for motions and the mirror image. A point joins those
/// that are placed once its distances to them leave it a single place; which distances do is found
/// by trying every point as the first one.
/// @throws Error  if they do not fix a point, or contradict each other or the triangle inequality
PlacedPoints placed_points(std::size_t count, std::span<const Distance> distances);

}  // namespace polhode
