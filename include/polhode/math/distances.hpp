// SPDX-License-Identifier: MIT
// Computes points from their mutual distances, such as the shape of a molecule given by
// constraints.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "polhode/base/vec3.hpp"

namespace polhode {

/// A known distance between two points.
struct Distance {
  std::size_t first, second;  ///< indices of the points
  double length;              ///< [nm]
};

/// Round-off [nm] of distances in files, usually given with five decimals.
inline constexpr double distance_rounding = 1e-5;
/// Largest allowed contradiction between redundant distances [nm].
inline constexpr double distance_tolerance = 1e-4;

struct PlacedPoints {
  std::vector<Vec3<double>> points;  ///< positions; the first point is at the origin, the second on
                                     ///< the x axis
  int dimension = 0;                 ///< dimension of the point set, 0 to 3; in 3 dimensions, the
                                     ///< mirror image is a second solution
};

/// Computes positions of points from their distances, unique up to rigid motions and reflection. A
/// point is placed as soon as its distances to already placed points determine its position. The
/// search tries every point as the first point.
/// @throws Error  if the distances do not determine all points, contradict each other, or violate
///   the triangle inequality
PlacedPoints place_points(std::size_t count, std::span<const Distance> distances);

}  // namespace polhode
