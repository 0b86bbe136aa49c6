// SPDX-License-Identifier: MIT
// What all scalar forms of the free rotation share: the result, and the units in which a top of any
// size turns without overflow.
#pragma once

#include <algorithm>
#include <cmath>

#include "polhode/math/rotation.hpp"

namespace polhode {

/// Where a free body is after a time t.
struct FreeRotation {
  /// attitude(t) = attitude(0) * rotation; the matrix_S() of it is the paper's P(t).
  Quaternion<double> rotation;
  /// Body-frame angular momentum at t, P(t) L(0).
  Vec3<double> L;
};

/// A top in units of its own, all powers of two: the largest moment and the largest component of L
/// are between 1/2 and 1. Nothing is rounded, and every threshold below is a relative one.
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

  /// J⁻¹ with the convention of linear bodies: 0 where the moment is 0.
  Vec3<double> inverse_J() const {
    const auto inverse = [](double moment) { return moment == 0 ? 0.0 : 1 / moment; };
    return {inverse(J.x), inverse(J.y), inverse(J.z)};
  }

  Vec3<double> in_units_of_caller(const Vec3<double>& l) const {
    return {std::ldexp(l.x, L_exponent), std::ldexp(l.y, L_exponent), std::ldexp(l.z, L_exponent)};
  }
};

}  // namespace polhode
