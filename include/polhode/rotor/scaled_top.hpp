// SPDX-License-Identifier: MIT
// Code shared by all scalar forms of the free rotation: the result type, and units in which a top
// of any size can be rotated without overflow.
#pragma once

#include <algorithm>
#include <cmath>

#include "polhode/math/rotation.hpp"

namespace polhode {

/// The rotation and angular momentum of a free body after a time t.
struct FreeRotation {
  /// orientation(t) = orientation(0) * rotation; its matrix_S() is the P(t) of the papers.
  Quaternion<double> rotation;
  /// Body-frame angular momentum P(t) L(0) at time t.
  Vec3<double> L;
};

/// A top in scaled units, in which the largest moment and the largest component of L are between
/// 1/2 and 1. The units are powers of two, so scaling causes no round-off. Thresholds are relative
/// to these units.
struct ScaledTop {
  Vec3<double> J, L;
  double t;
  int L_exponent;  ///< exponent of the unit of L: L was divided by 2^L_exponent

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

  /// The inverse moments J⁻¹, with the convention for linear bodies that the inverse of 0 is 0.
  Vec3<double> inverse_J() const {
    const auto inverse = [](double moment) { return moment == 0 ? 0.0 : 1 / moment; };
    return {inverse(J.x), inverse(J.y), inverse(J.z)};
  }

  Vec3<double> in_units_of_caller(const Vec3<double>& l) const {
    return {std::ldexp(l.x, L_exponent), std::ldexp(l.y, L_exponent), std::ldexp(l.z, L_exponent)};
  }
};

}  // namespace polhode
