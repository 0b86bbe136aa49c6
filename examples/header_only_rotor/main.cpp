// SPDX-License-Identifier: MIT
// The Dzhanibekov effect, using only the headers of the rotor.
//  A wing nut spinning about its axis of middle moment of inertia flips over repeatedly: rotation
// about the middle axis is unstable, and a small tilt grows as exp(λ t) with λ² = (J₃ − J₂)(J₂ −
// J₁)/(J₁ J₃) ω². The angular momentum in the laboratory frame is constant; it is the body that
// turns around it. Here a nut is followed over a thousand turns in steps, once with the exact free
// rotation and once with NO_SQUISH, the second-order splitting used by most molecular dynamics
// programs. Both conserve angular momentum; only the exact one conserves the energy.
//
//     c++ -std=c++20 -O2 -I include examples/header_only_rotor/main.cpp -o nut && ./nut
#include <cmath>
#include <cstdio>

#include "polhode/rotor/free_rotation.hpp"

using namespace polhode;

namespace {

double energy(const Vec3<double>& J, const Vec3<double>& L) {
  return 0.5 * (L.x * L.x / J.x + L.y * L.y / J.y + L.z * L.z / J.z);
}

/// Rotates the nut by `steps` steps; returns the largest relative error of the energy.
double carry(RotorMethod method, const Vec3<double>& J, const Vec3<double>& ell, double step,
             int steps) {
  Quaternion<double> orientation;  // body → lab
  double worst = 0;
  int flips = 0;
  bool up = true;
  for (int n = 0; n < steps; ++n) {
    const Vec3<double> L = to_body(orientation, ell);
    worst = std::fmax(worst, std::abs(energy(J, L) / energy(J, ell) - 1));
    if ((L.y > 0) != up) {
      up = !up;
      ++flips;
    }
    orientation = normalized(orientation * free_rotation(J, L, step, method).rotation);
  }
  std::printf("%-10s %3d flips, largest relative energy error %.1e\n",
              method == RotorMethod::series ? "exact" : "NO_SQUISH", flips, worst);
  return worst;
}

}  // namespace

int main() {
  const Vec3<double> J{1, 2, 2.5};        // any consistent units
  const Vec3<double> ell{1e-3, 2, 1e-3};  // ω = 1 about the middle axis, tilted by a thousandth
  const double step = 0.1;
  const int steps = 62832;  // a thousand turns

  const double exact = carry(RotorMethod::series, J, ell, step, steps);
  const double split = carry(RotorMethod::no_squish, J, ell, step, steps);

  // One unbiased rounding per step makes a random walk of about ε √N; the bound is six times that.
  // A split step with ω h = 0.1 has a relative error of about (ω h)²/12.
  const double bound = 12 * 0x1p-53 * std::sqrt(steps);
  const bool conserved = exact < bound && split > 1e-5;
  std::printf("exact energy error below %.1e: %s\n", bound, conserved ? "yes" : "no");
  return conserved ? 0 : 1;
}
