// SPDX-License-Identifier: MIT
// Common entry point to all forms of the free rotation, for single bodies of any shape and in any
// units.
#pragma once

#include <array>

#include "polhode/base/enum_names.hpp"
#include "polhode/rotor/comparison/no_squish.hpp"
#include "polhode/rotor/comparison/recursive.hpp"
#include "polhode/rotor/comparison/symmetric_product.hpp"
#include "polhode/rotor/free_rotor.hpp"
#include "polhode/rotor/series.hpp"

namespace polhode {

enum class RotorMethod {
  series,             ///< power series, as in molecular dynamics; beyond |ω t| = 0.3, the closed
                      ///< form
  closed,             ///< closed form: elliptic functions and Carlson's integral of the third kind
  theta,              ///< closed form: elliptic functions, and the integral of the third kind from
                      ///< theta functions
  recursive,          ///< elliptic functions and two-point Hermite quadrature
  no_squish,          ///< NO_SQUISH splitting of second order, for comparison
  symmetric_product,  ///< symmetric product of second order, for comparison
};

template <>
inline constexpr std::array<std::string_view, 6> enum_names<RotorMethod> = {
    "series", "closed", "theta", "recursive", "no-squish", "symmetric-product"};

/// Computes the free rotation by the series within its range, and by the closed
/// form at larger angles. The closed form is also used for moments that no mass distribution has
/// (J_z > J_x + J_y), because the error bound of the series does not hold for such moments.
/// Sub-steps are not used, because they gain nothing for a single body.
/// @param J, L, t  as for closed_rotation()
inline FreeRotation series_or_closed_rotation(const Vec3<double>& J, const Vec3<double>& L,
                                              double t) {
  const ScaledTop top(J, L, t);
  const Vec3<double> i = top.inverse_J();
  const Vec3<double> angle = top.t * scaled(i, top.L);
  const double radius = std::hypot(angle.x, angle.y, angle.z);
  const Vec3<double>& m = top.J;
  const double slack = 1 + 1e-9;  // tolerance for the round-off of inputs
  const bool physical =
      m.x <= (m.y + m.z) * slack && m.y <= (m.z + m.x) * slack && m.z <= (m.x + m.y) * slack;
  if (!physical || !(radius <= long_series.radius)) return closed_rotation(J, L, t);
  const Quaternion<double> r = normalized(unnormalized_rotation<long_series>(i, top.L, top.t));
  return {r, top.in_units_of_caller(momentum_after(r, top.L))};
}

/// Computes the rotation of a free rigid body, orientation(t) = orientation(0) * rotation, and its
/// angular momentum L(t).
///
/// @param J  principal moments [u nm²] in any order; one may be zero (linear body)
/// @param L  body-frame angular momentum [u nm²/ps], zero along a vanishing moment
/// @param t  time [ps], any sign
inline FreeRotation free_rotation(const Vec3<double>& J, const Vec3<double>& L, double t,
                                  RotorMethod method = RotorMethod::series) {
  switch (method) {
    case RotorMethod::closed:
      return closed_rotation(J, L, t);
    case RotorMethod::theta:
      return closed_rotation(J, L, t, ThirdKind::theta);
    case RotorMethod::recursive:
      return recursive_rotation(J, L, t);
    case RotorMethod::no_squish:
      return no_squish_rotation(J, L, t);
    case RotorMethod::symmetric_product:
      return symmetric_product_rotation(J, L, t);
    case RotorMethod::series:
      break;
  }
  return series_or_closed_rotation(J, L, t);
}

}  // namespace polhode
