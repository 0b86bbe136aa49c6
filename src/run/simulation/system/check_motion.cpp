// SPDX-License-Identifier: MIT
#include "run/simulation/system/check_motion.hpp"

#include <fmt/core.h>

#include <cmath>

#include "polhode/base/error.hpp"

namespace polhode {
namespace {

constexpr double max_position = 1e6;  // Maximum position [nm]. Beyond this value, a double resolves
                                      // less than 1e-10 nm.

bool finite(const Vec3<double>& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

[[noreturn]] void refuse(std::size_t body, const char* quantity, const Vec3<double>& v,
                         const std::string& complaint) {
  throw Error(fmt::format("the {} of molecule {} is ({:.6g}, {:.6g}, {:.6g}); {}", quantity,
                          body + 1, v.x, v.y, v.z, complaint));
}

void check_finite(std::size_t body, const char* quantity, const Vec3<double>& v) {
  if (!finite(v)) refuse(body, quantity, v, "the components must be finite numbers");
}

/// Checks that the angular momentum along an axis with no moment of inertia is zero within the
/// round-off of the whole angular momentum.
void check_axes(std::size_t body, const Vec3<double>& ell, const Quaternion<double>& orientation,
                const Vec3<double>& J) {
  constexpr double rounding = 1e-9;
  const Vec3<double> L = to_body(orientation, ell);
  for (std::size_t k = 0; k < 3; ++k)
    if (J[k] == 0 && std::abs(L[k]) > rounding * norm(L))
      refuse(body, "angular momentum", ell,
             fmt::format("the component of {:.3g} u nm2/ps along its principal axis {} must be 0, "
                         "since the moment of inertia about this axis is 0",
                         L[k], k + 1));
}

/// Returns the orientation as a unit quaternion. If the quaternion is already normalized up to
/// round-off, its bits do not change.
Quaternion<double> checked_orientation(std::size_t body, const Quaternion<double>& s) {
  constexpr double rounding = 1e-14, smallest = 1e-100, largest = 1e100;
  const double squared = norm2(s);
  if (!(squared > smallest && squared < largest))
    throw Error(
        fmt::format("the orientation of molecule {} is ({:.6g}, {:.6g}, {:.6g}, {:.6g}); it must "
                    "be a quaternion (w, x, y, z) that can be normalized",
                    body + 1, s.w, s.x, s.y, s.z));
  return std::abs(squared - 1) < rounding ? s : normalized(s);
}

}  // namespace

void check_motion(State& state, const Bodies& bodies) {
  for (std::size_t i = 0; i < state.size(); ++i) {
    check_finite(i, "position [nm]", state.q[i]);
    if (!(norm(state.q[i]) <= max_position))
      refuse(i, "position [nm]", state.q[i],
             fmt::format("it must be within {:g} nm of the origin", max_position));
    check_finite(i, "momentum [u nm/ps]", state.p[i]);
    check_finite(i, "angular momentum [u nm2/ps]", state.ell[i]);
    const Quaternion<double> orientation = checked_orientation(i, state.orientation[i]);
    check_axes(i, state.ell[i], orientation, bodies.J[i]);
    state.orientation.set(i, orientation);
  }
}

}  // namespace polhode
