// SPDX-License-Identifier: MIT
// Shapes of point sets, independent of position and orientation.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "polhode/base/vec3.hpp"

namespace polhode {

using Shape = std::vector<Vec3<double>>;

/// The mean of several copies of a shape, each superposed on the first copy. The centre of the mean
/// is at the origin.
/// @param copy  returns the copy with a given index, in any frame
Shape mean_shape(std::size_t copies, const std::function<Shape(std::size_t)>& copy);

/// The largest distance between corresponding points of two shapes after their best superposition
/// with equal weights.
double difference(const Shape& a, const Shape& b);

/// Largest distance of collinear points from their line, if coordinates are rounded to three
/// decimals [nm].
inline constexpr double line_rounding = 0.002;

/// Moves points that are collinear to within `line_rounding` exactly onto a line. Without this
/// correction, a linear body would spin about its axis with a tiny moment of inertia.
Shape straighten(Shape shape);

/// A shape in its principal frame, with axis signs that do not depend on the given orientation.
/// Along each axis, the first point that is far from the centre has a positive coordinate.
Shape principal_shape(Shape shape, std::span<const double> mass);

/// The mirror image of a shape.
Shape mirror_image(Shape shape);

}  // namespace polhode
