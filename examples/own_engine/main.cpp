// SPDX-License-Identifier: MIT
// A tethered rigid dipole: the table of schemes and the free rotor in an engine of your own.
//
// A water-like top is attached to the origin by a spring, and its dipole interacts with a field E
// along z that increases with height, V = k |q|²/2 − (1 + g z) μ·E. Translation and rotation are
// coupled: the better the body is aligned, the more the field pulls it upward, and the higher it
// is, the stronger the torque. Each scheme of the table is run with two steps; the energy error of
// a scheme of order k is proportional to hᵏ, so halving the step divides it by 2ᵏ. Only the
// forces are written here; flows and schemes come from headers, without any library:
//
//     g++ -std=c++20 -O2 -I include examples/own_engine/main.cpp
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "polhode/integrate/body_flows.hpp"
#include "polhode/integrate/schemes.hpp"

namespace {

using polhode::BodyLoad;
using polhode::RigidBody;
using Vec3 = polhode::Vec3<double>;

constexpr Vec3 mu{0.04, 0.0, 0.0};                 // dipole in the body frame [e nm]
constexpr double E = 300, g = 3, stiffness = 800;  // [kJ/mol/e/nm], [1/nm], [kJ/mol/nm²]

BodyLoad load(const RigidBody& body) {
  const Vec3 dipole = polhode::to_lab(body.orientation, mu);
  const Vec3 field{0, 0, E * (1 + g * body.q.z)};
  return {-stiffness * body.q + Vec3{0, 0, g * E * dipole.z}, polhode::cross(dipole, field)};
}

double energy(const RigidBody& body) {
  const Vec3 dipole = polhode::to_lab(body.orientation, mu);
  return body.kinetic_energy() + stiffness * polhode::norm2(body.q) / 2 -
         E * (1 + g * body.q.z) * dipole.z;
}

double largest_error(const polhode::Scheme& scheme, double h, int steps) {
  std::array bodies{RigidBody{
      .m = 18.0,
      .J = {0.00615, 0.01155, 0.01770},
      .q = {0.02, -0.01, 0.03},
      .p = {3, 1, -2},
      .orientation = polhode::normalized(polhode::Quaternion<double>{0.8, 0.2, 0.5, -0.1}),
      .ell = {0.10, 0.08, -0.12}}};
  polhode::BodyFlows flows(bodies, [](auto all, auto loads) {
    std::transform(all.begin(), all.end(), loads.begin(), load);
  });
  const double start = energy(bodies[0]);
  double worst = 0;
  for (int n = 0; n < steps; ++n) {
    polhode::step(scheme, flows, h);
    worst = std::max(worst, std::abs(energy(bodies[0]) - start));
  }
  return worst;
}

}  // namespace

int main() {
  bool all_hold = true;
  std::printf("%-16s %5s %5s  %12s %12s  %s\n", "scheme", "order", "h/fs", "error, h", "h/2",
              "measured");
  for (const polhode::Scheme& scheme : polhode::schemes) {
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
