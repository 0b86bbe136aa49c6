// SPDX-License-Identifier: MIT
// Shapes of point sets, freed from where and how they lie.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "polhode/base/vec3.hpp"

namespace polhode {

using Shape = std::vector<Vec3<double>>;

/// The mean of several copies of a shape, each turned onto the first; its centre is in the origin.
/// @param copy  gives one copy by its index, in any frame
Shape mean_shape(std::size_t copies, const std::function<Shape(std::size_t)>& copy);

/// The largest distance of a point from its place when two shapes lie on each other as well as they
/// can, all points with the same weight.
double difference(const Shape& a, const Shape& b);

/// Coordinates of three decimals put points of a line so far off it [nm].
inline constexpr double line_rounding = 0.002;

/// Points that lie along a line but for `line_rounding` are put on it: a linear body would else
/// spin about its axis, which nearly nothing resists.
Shape straightened(Shape shape);

/// The same shape in a mirror.
Shape mirrored(Shape shape);

}  // namespace polhode
