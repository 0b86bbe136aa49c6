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

/// The mean of several copies of a shape, each rotated onto the first; its centre is at the origin.
/// @param copy  returns the copy with a given index, in any frame
Shape mean_shape(std::size_t copies, const std::function<Shape(std::size_t)>& copy);

/// The largest distance between corresponding points after the best superposition of two shapes,
/// with equal weights.
double difference(const Shape& a, const Shape& b);

/// Distance by which coordinates with three decimals may put collinear points off their line [nm].
inline constexpr double line_rounding = 0.002;

/// Puts points that are collinear to within `line_rounding` exactly on a line: a linear body would
/// otherwise spin about its axis with nearly zero inertia.
Shape straighten(Shape shape);

/// A shape in its principal frame, with signs that do not depend on the given orientation. The
/// first point far from the centre along an axis is on the positive side.
Shape principal_shape(Shape shape, std::span<const double> mass);

/// The mirror image of a shape.
Shape mirror_image(Shape shape);

}  // namespace polhode
