// SPDX-License-Identifier: MIT
// The free rotation as a symmetric product of rotations about the principal axes. The method has
// second order and is included only for comparison.
#pragma once

#include <array>

#include "polhode/rotor/scaled_top.hpp"

namespace polhode {

/// The symmetric product e^{z t/2} e^{y t/2} e^{x t} e^{y t/2} e^{z t/2}. Each factor is the exact
/// flow of L_k²/(2 J_k), which is a rotation about body axis k. The orientation error is O(t³) per
/// step.
///
/// @param J, L, t  as for closed_rotation()
/// @source dullweber1997
inline FreeRotation symmetric_product_rotation(const Vec3<double>& J, const Vec3<double>& L,
                                               double t) {
  const ScaledTop top(J, L, t);
  const Vec3<double> inverse_J = top.inverse_J();
  FreeRotation state{{}, top.L};
  constexpr std::array<std::size_t, 5> axes{2, 1, 0, 1, 2};
  for (const std::size_t axis : axes) {
    Vec3<double> turn;
    turn[axis] = inverse_J[axis] * state.L[axis] * (axis == 0 ? top.t : 0.5 * top.t);
    const Quaternion<double> r = rotation_quaternion(turn);
    state = {state.rotation * r, to_body(r, state.L)};
  }
  return {normalized(state.rotation), top.in_units_of_caller(state.L)};
}

}  // namespace polhode
