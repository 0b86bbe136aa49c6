// SPDX-License-Identifier: MIT
// Rotations by an angle about an axis, and quaternions from orthogonal matrices.
#pragma once

#include <algorithm>
#include <cmath>

#include "polhode/base/quaternion.hpp"

namespace polhode {

/// The active rotation by the angle |v| about v, as a unit quaternion; v = 0 gives the identity.
/// Components of v must be below 1e150. Components below 1e-150 are negligible and may underflow.
inline Quaternion<double> rotation_quaternion(const Vec3<double>& v) {
  const double angle = std::hypot(v.x, v.y, v.z);
  if (angle == 0) return {};
  const double s = std::sin(0.5 * angle) / angle;
  return {std::cos(0.5 * angle), s * v.x, s * v.y, s * v.z};
}

/// The unit quaternion q, with w ≥ 0, of an active rotation matrix A(q). The conversion divides by
/// the component with the largest magnitude, so that no component loses accuracy.
inline Quaternion<double> quaternion_of(const Mat3<double>& a) {
  const double trace = a[0].x + a[1].y + a[2].z;
  const double largest = std::max({trace, a[0].x, a[1].y, a[2].z});
  Quaternion<double> q;
  if (largest == trace) {
    q = {1 + trace, a[2].y - a[1].z, a[0].z - a[2].x, a[1].x - a[0].y};
  } else if (largest == a[0].x) {
    q = {a[2].y - a[1].z, 1 + a[0].x - a[1].y - a[2].z, a[1].x + a[0].y, a[0].z + a[2].x};
  } else if (largest == a[1].y) {
    q = {a[0].z - a[2].x, a[1].x + a[0].y, 1 + a[1].y - a[0].x - a[2].z, a[2].y + a[1].z};
  } else {
    q = {a[1].x - a[0].y, a[0].z + a[2].x, a[2].y + a[1].z, 1 + a[2].z - a[0].x - a[1].y};
  }
  return scaled(q, std::copysign(1 / std::sqrt(norm2(q)), q.w));
}

}  // namespace polhode
