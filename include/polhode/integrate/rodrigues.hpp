// SPDX-License-Identifier: MIT
// Rotation by a vector.
#pragma once

#include <cmath>

#include "polhode/base/quaternion.hpp"

namespace polhode {

/// The rotation R(v) = exp(−[v]×) as a body → lab quaternion factor: orientation · rodrigues(v)
/// rotates a body by the body-frame vector v [vanzon2008, below Eq. 7]. The rotated matrix is S̃ =
/// R(v) S.
inline Quaternion<double> rodrigues(const Vec3<double>& v) {
  const double half = norm(v) / 2;
  const double s = half > 0 ? std::sin(half) / (2 * half) : 0.5;
  return {std::cos(half), s * v.x, s * v.y, s * v.z};
}

}  // namespace polhode
