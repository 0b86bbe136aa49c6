// SPDX-License-Identifier: MIT
// Points from their distances: the shape of a molecule that is given by constraints.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "polhode/base/vec3.hpp"

namespace polhode {

/// A given distance between two points.
struct Distance {
  std::size_t first, second;  ///< indices of points
  double length;              ///< [nm]
};

/// Distances in files are rounded: five decimals are usual [nm].
inline constexpr double distance_rounding = 1e-5;
/// Tolerance for redundant distances that contradict each other [nm].
inline constexpr double distance_tolerance = 1e-4;

struct PlacedPoints {
  std::vector<Vec3<double>> points;  ///< the first at the origin, the second on the x axis
  int dimension = 0;                 ///< 0 to 3; in 3, the mirror image has the same distances
};

/// The positions determined by the distances, unique up to rigid motions and the mirror image. A
/// point is placed once its distances to points already placed determine its position; every point
/// is tried as the first one.
/// @throws Error  if the distances do not determine a point, or contradict each other or the
///                triangle inequality
PlacedPoints place_points(std::size_t count, std::span<const Distance> distances);

}  // namespace polhode
