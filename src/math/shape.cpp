// SPDX-License-Identifier: MIT
#include "polhode/math/shape.hpp"

#include <algorithm>

#include "polhode/math/eigen.hpp"

namespace polhode {
namespace {

Shape centre_at_origin(Shape shape) {
  Vec3<double> centre{};
  for (const Vec3<double>& r : shape) centre += r;
  for (Vec3<double>& r : shape) r -= centre / static_cast<double>(shape.size());
  return shape;
}

// The shape rotated onto `onto`; both are centred.
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

Shape mirror_image(Shape shape) {
  for (Vec3<double>& r : shape) r.z = -r.z;
  return shape;
}

}  // namespace polhode
