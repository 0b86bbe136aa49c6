// SPDX-License-Identifier: MIT
// A tethered rigid dipole: the table of schemes and the free rotor in an engine of your own.
//
// A water-like top is attached to the origin by a spring, and its dipole interacts with a field E
// along z that increases with height, V = k |q|²/2 − (1 + g z) μ·E. Translation and rotation are
// coupled: the better the body is aligned, the more the field pulls it upward, and the higher it
// is, the stronger the torque. Each scheme of the table is run with two steps; the energy error of
// a scheme of order k is proportional to hᵏ, so halving the step divides it by 2ᵏ. Everything below
// the forces is header-only:
//
//     g++ -std=c++20 -O2 -I include examples/own_engine/main.cpp
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "polhode/integrate/schemes.hpp"
#include "polhode/rotor/free_rotation.hpp"

namespace {

using polhode::Flow;
using polhode::Quaternion;
using polhode::Scheme;
using polhode::Stage;
using Vec3 = polhode::Vec3<double>;

constexpr double m = 18.0;                         // [u]
constexpr Vec3 J{0.00615, 0.01155, 0.01770};       // [u nm²]
constexpr Vec3 mu{0.04, 0.0, 0.0};                 // dipole in the body frame [e nm]
constexpr double E = 300, g = 3, stiffness = 800;  // [kJ/mol/e/nm], [1/nm], [kJ/mol/nm²]

struct Body {
  Vec3 q{0.02, -0.01, 0.03}, p{3, 1, -2};
  Quaternion<double> attitude = polhode::normalized(Quaternion<double>{0.8, 0.2, 0.5, -0.1});
  Vec3 ell{0.10, 0.08, -0.12};
};

struct Load {
  Vec3 f, tau;
};

Load load(const Vec3& q, const Quaternion<double>& attitude) {
  const Vec3 dipole = polhode::to_lab(attitude, mu);
  const Vec3 field{0, 0, E * (1 + g * q.z)};
  return {-stiffness * q + Vec3{0, 0, g * E * dipole.z}, polhode::cross(dipole, field)};
}

double energy(const Body& b) {
  const Vec3 L = polhode::to_body(b.attitude, b.ell);
  const Vec3 dipole = polhode::to_lab(b.attitude, mu);
  return polhode::norm2(b.p) / (2 * m) + L.x * L.x / (2 * J.x) + L.y * L.y / (2 * J.y) +
         L.z * L.z / (2 * J.z) + stiffness * polhode::norm2(b.q) / 2 -
         E * (1 + g * b.q.z) * dipole.z;
}

// e^{Bt}, or for ξ ≠ 0 the gradient kick by finite difference (vanzon2008, Eqs. 4 to 7).
void kick(Body& b, const Stage& stage, double h) {
  Load now = load(b.q, b.attitude);
  if (stage.xi != 0) {
    constexpr double lambda = 1e-4;
    const double c = 2 * stage.xi * lambda * h * h;
    const Vec3 torque = polhode::to_body(b.attitude, now.tau);
    const Vec3 v{c * torque.x / J.x, c * torque.y / J.y, c * torque.z / J.z};
    const auto turned = polhode::normalized(
        b.attitude * Quaternion<double>{1, v.x / 2, v.y / 2, v.z / 2});  // R(v) for a small v
    const Load there = load(b.q + (c / m) * now.f, turned);
    now.f += (1 / lambda) * (there.f - now.f);
    now.tau += (1 / lambda) * (there.tau - now.tau);
  }
  b.p += stage.fraction * h * now.f;
  b.ell += stage.fraction * h * now.tau;
}

// e^{At}: free flight and the exact free rotation (vanzon2008, Eq. 2).
void drift(Body& b, double t) {
  b.q += (t / m) * b.p;
  const Vec3 L = polhode::to_body(b.attitude, b.ell);
  b.attitude = polhode::normalized(
      b.attitude * polhode::free_rotation(J, L, t, polhode::RotorMethod::series).rotation);
}

double largest_error(const Scheme& scheme, double h, int steps) {
  Body b;
  const double start = energy(b);
  double worst = 0;
  for (int n = 0; n < steps; ++n) {
    for (const Stage& stage : scheme.stages()) {
      if (stage.flow == Flow::drift)
        drift(b, stage.fraction * h);
      else
        kick(b, stage, h);
    }
    worst = std::max(worst, std::abs(energy(b) - start));
  }
  return worst;
}

}  // namespace

int main() {
  bool all_hold = true;
  std::printf("%-16s %5s %5s  %12s %12s  %s\n", "scheme", "order", "h/fs", "error, h", "h/2",
              "measured");
  for (const Scheme& scheme : polhode::schemes) {
    const double h = scheme.order() > 4 ? 0.006 : 0.001;  // [ps]; at 1 fs, the error of sixth-order
                                                          // schemes is all rounding
    const double coarse = largest_error(scheme, h, 200);
    const double fine = largest_error(scheme, h / 2, 400);
    const double order = std::log2(coarse / fine);
    std::printf("%-16s %5d %5g  %12.3e %12.3e  %.2f\n", scheme.name().data(), scheme.order(),
                h * 1000, coarse, fine, order);
    all_hold = all_hold && std::abs(order - scheme.order()) < 0.1;
  }
  return all_hold ? 0 : 1;
}
