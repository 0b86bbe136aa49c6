// SPDX-License-Identifier: MIT
// Common to all scalar forms of the free rotation: the result, and units in which a top of any size
// can be rotated without overflow.
#pragma once

#include <algorithm>
#include <cmath>

#include "polhode/math/rotation.hpp"

namespace polhode {

/// State of a free body after a time t.
struct FreeRotation {
  /// orientation(t) = orientation(0) * rotation; its matrix_S() is the P(t) of the papers.
  Quaternion<double> rotation;
  /// Body-frame angular momentum at t, P(t) L(0).
  Vec3<double> L;
};

/// A top in its own units, all powers of two: the largest moment and the largest component of L are
/// between 1/2 and 1. Nothing is rounded, and all thresholds below are relative.
struct ScaledTop {
  Vec3<double> J, L;
  double t;
  int L_exponent;  ///< L was divided by 2^L_exponent

  ScaledTop(const Vec3<double>& moments, const Vec3<double>& momentum, double time) {
    const auto exponent = [](const Vec3<double>& v) {
      int e = 0;
      std::frexp(std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}), &e);
      return e;
    };
    const auto shifted = [](const Vec3<double>& v, int e) {
      return Vec3<double>{std::ldexp(v.x, e), std::ldexp(v.y, e), std::ldexp(v.z, e)};
    };
    const int J_exponent = exponent(moments);
    L_exponent = exponent(momentum);
    J = shifted(moments, -J_exponent);
    L = shifted(momentum, -L_exponent);
    t = std::ldexp(time, L_exponent - J_exponent);
  }

  /// J⁻¹ with the convention for linear bodies: 0 if the moment is 0.
  Vec3<double> inverse_J() const {
    const auto inverse = [](double moment) { return moment == 0 ? 0.0 : 1 / moment; };
    return {inverse(J.x), inverse(J.y), inverse(J.z)};
  }

  Vec3<double> in_units_of_caller(const Vec3<double>& l) const {
    return {std::ldexp(l.x, L_exponent), std::ldexp(l.y, L_exponent), std::ldexp(l.z, L_exponent)};
  }
};

}  // namespace polhode
