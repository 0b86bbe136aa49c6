// SPDX-License-Identifier: MIT
// What another engine takes, the free rotor and the schemes: a quarter of a turn about the axis of
// a symmetric top is known.
#include <cmath>
#include <cstdio>

#include "polhode/integrate/schemes.hpp"
#include "polhode/rotor/free_rotation.hpp"

int main() {
  const polhode::Vec3<double> J{1, 1, 2}, L{0, 0, 2};
  const double quarter = std::acos(0.0);  // of a turn, at ω = 1
  const auto turn = polhode::free_rotation(J, L, quarter, polhode::RotorMethod::closed);
  const double error = std::abs(std::abs(turn.rotation.w) - std::sqrt(0.5));
  std::printf("%zu schemes, error %g\n", std::size(polhode::schemes), error);
  return error < 1e-14 ? 0 : 1;  // some roundings of numbers below 1
}
