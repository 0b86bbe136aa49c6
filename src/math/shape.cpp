// SPDX-License-Identifier: MIT
#include "polhode/math/shape.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "math/eigen.hpp"

namespace polhode {
namespace {

Shape centre_at_origin(Shape shape) {
  Vec3<double> centre{};
  for (const Vec3<double>& r : shape) centre += r;
  for (Vec3<double>& r : shape) r -= centre / static_cast<double>(shape.size());
  return shape;
}

// A shape after rotation onto the shape `onto`; both shapes have their centre at the origin.
Shape rotate_onto(Shape shape, const Shape& onto) {
  const std::vector<double> weight(shape.size(), 1.0);
  const Quaternion<double> turn = best_rotation(shape, onto, weight);
  for (Vec3<double>& r : shape) r = to_lab(turn, r);
  return shape;
}

}  // namespace

Shape mean_shape(std::size_t copies, const std::function<Shape(std::size_t)>& copy) {
  const Shape first = centre_at_origin(copy(0));
  Shape sum = first;
  for (std::size_t k = 1; k < copies; ++k) {
    const Shape next = rotate_onto(centre_at_origin(copy(k)), first);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += next[i];
  }
  for (Vec3<double>& r : sum) r = r / static_cast<double>(copies);
  return sum;
}

double difference(const Shape& a, const Shape& b) {
  const Shape there = centre_at_origin(b), here = rotate_onto(centre_at_origin(a), there);
  double largest = 0;
  for (std::size_t i = 0; i < here.size(); ++i)
    largest = std::max(largest, norm(here[i] - there[i]));
  return largest;
}

Shape straighten(Shape shape) {
  if (shape.empty()) return shape;
  shape = centre_at_origin(std::move(shape));
  Mat3<double> inertia{};  // Σ (r² 1 − r rᵀ)
  for (const Vec3<double>& r : shape)
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k) inertia[i][k] += (i == k ? norm2(r) : 0.0) - r[i] * r[k];
  const Vec3<double> axis = symmetric_eigen(inertia).vectors[0];
  const auto along = [&](const Vec3<double>& r) { return dot(r, axis) * axis; };
  for (const Vec3<double>& r : shape)
    if (norm(r - along(r)) > line_rounding) return shape;
  for (Vec3<double>& r : shape) r = along(r);
  return shape;
}

Shape principal_shape(Shape shape, std::span<const double> mass) {
  Vec3<double> centre{};
  double all = 0;
  for (std::size_t i = 0; i < shape.size(); ++i) centre += mass[i] * shape[i], all += mass[i];
  Mat3<double> inertia{};  // Σ m (r² 1 − r rᵀ)
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const Vec3<double> r = shape[i] -= centre / all;
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b)
        inertia[a][b] += mass[i] * ((a == b ? norm2(r) : 0.0) - r[a] * r[b]);
  }
  Mat3<double> axes = symmetric_eigen(inertia).vectors;
  for (std::size_t k = 0; k < 2; ++k) {
    const auto along = [&](const Vec3<double>& r) { return dot(axes[k], r); };
    double extent = 0;
    for (const Vec3<double>& r : shape) extent = std::max(extent, std::abs(along(r)));
    constexpr double far = 0.6;  // no point of a symmetric shape is near this value, because its
                                 // sample points are at 1/2 and √(3/4)
    const auto first = std::find_if(shape.begin(), shape.end(), [&](const Vec3<double>& r) {
      return std::abs(along(r)) > far * extent;
    });
    if (first != shape.end() && along(*first) < 0) axes[k] = -axes[k];
  }
  axes[2] = cross(axes[0], axes[1]);
  for (Vec3<double>& r : shape) r = axes * r;
  return shape;
}

Shape mirror_image(Shape shape) {
  for (Vec3<double>& r : shape) r.z = -r.z;
  return shape;
}

}  // namespace polhode
