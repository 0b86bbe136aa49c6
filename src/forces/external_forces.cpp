// SPDX-License-Identifier: MIT
#include "polhode/forces/external_forces.hpp"

#include <algorithm>
#include <cmath>

#include "polhode/math/rotation.hpp"

namespace polhode {
namespace {

double largest(const Vec3Column& v) {
  double norm_squared = 0;
  for (std::size_t i = 0; i < v.size(); ++i) norm_squared = std::max(norm_squared, norm2(v[i]));
  return std::sqrt(norm_squared);
}

State displaced(const State& state, const Vec3Column& dq, const Vec3Column& dtheta, double by) {
  State moved = state;
  for (std::size_t i = 0; i < state.size(); ++i) {
    moved.q.add(i, by * dq[i]);
    const Vec3<double> turn = by * dtheta[i];
    moved.orientation.set(i, normalized(state.orientation[i] * rotation_quaternion(turn)));
  }
  return moved;
}

}  // namespace

void add_derivative(const ExternalForces& forces, const State& state, const Vec3Column& dq,
                    const Vec3Column& dtheta, Load& slope) {
  // The truncation error of the central difference is of second order in the displacement. The
  // truncation error equals the round-off error if the displacement is about the cube root of the
  // relative round-off. The optimal displacement is 1e-5 of the scale over which forces change,
  // which is 0.1 nm and a radian.
  constexpr double displacement = 1e-6;  // displacement in nm and in rad
  const double most = std::max(largest(dq), largest(dtheta));
  if (!(most > 0)) return;
  const double by = displacement / most;
  Load ahead(state.size()), behind(state.size());
  forces.add(displaced(state, dq, dtheta, by), ahead);
  forces.add(displaced(state, dq, dtheta, -by), behind);
  for (std::size_t i = 0; i < state.size(); ++i) {
    slope.f.add(i, (ahead.f[i] - behind.f[i]) / (2 * by));
    slope.tau.add(i, (ahead.tau[i] - behind.tau[i]) / (2 * by));
  }
}

}  // namespace polhode
