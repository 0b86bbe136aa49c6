// SPDX-License-Identifier: MIT
// Where to put the heat bath: flows of your own, with nothing but the headers of the schemes.
//
// An oscillator p²/2 + q²/2 in a bath at kT = 1 has <q²> = <p²> = 1. A scheme for Langevin dynamics
// shifts both by an amount that depends on the step h and on where its bath O acts. Drift, kick and
// bath are linear in q and p, so a Gaussian distribution stays one, and each flow can act on its
// second moments instead of on a single oscillator: the stationary averages follow without any
// sampling. With the bath between two drifts, <q²> is exact for every h [leimkuhler2013]; with the
// bath at the ends of the step, the error is in <q²>. Neither depends on the friction.
//
//     g++ -std=c++20 -O2 -I include examples/heat_bath/main.cpp -o bath && ./bath
#include <cmath>
#include <cstdio>

#include "polhode/integrate/step.hpp"

namespace {

using polhode::A, polhode::B, polhode::O, polhode::Scheme;

constexpr Scheme baoab("baoab", 2, {B(0.5), A(0.5), O(1)}, "leimkuhler2013");
constexpr Scheme obabo("obabo", 2, {O(0.5), B(0.5), A(1)}, "leimkuhler2013");

// Second moments of an oscillator with m = k = kT = 1.
struct Moments {
  double friction;
  double qq = 0, qp = 0, pp = 0;  // at rest at the origin

  void drift(double t) {  // q ← q + t p
    qq += 2 * t * qp + t * t * pp;
    qp += t * pp;
  }
  void kick(double t) {  // p ← p − t q
    pp += -2 * t * qp + t * t * qq;
    qp -= t * qq;
  }
  void bath(double t, polhode::StageNumber) {  // p ← c p + √(1 − c²) times a normal deviate
    const double c = std::exp(-friction * t);
    qp *= c;
    pp = c * c * pp + 1 - c * c;
  }
};

Moments stationary(const Scheme& scheme, double h, double friction) {
  Moments moments{friction};
  const int steps = static_cast<int>(100 / (h * std::fmin(friction, 1 / friction)));
  for (int n = 0; n < steps; ++n) polhode::step(scheme, moments, h);
  return moments;
}

}  // namespace

int main() {
  bool all_hold = true;
  std::printf("%-6s %5s %9s  %9s %9s\n", "scheme", "h", "friction", "<q2>", "<p2>");
  for (const Scheme& scheme : {baoab, obabo})
    for (const double h : {0.25, 0.5, 1.0, 1.5})
      for (const double friction : {0.5, 2.0}) {
        const Moments m = stationary(scheme, h, friction);
        std::printf("%-6s %5g %9g  %9.6f %9.6f\n", scheme.name().data(), h, friction, m.qq, m.pp);
        const bool between = scheme.name() == "baoab";
        const double qq = between ? 1 : 1 / (1 - h * h / 4), pp = between ? 1 - h * h / 4 : 1;
        all_hold = all_hold && std::fabs(m.qq - qq) < 1e-12 && std::fabs(m.pp - pp) < 1e-12;
      }
  return all_hold ? 0 : 1;
}
