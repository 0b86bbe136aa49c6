// SPDX-License-Identifier: MIT
#include "integrate/stability.hpp"

#include <cmath>

#include "polhode/integrate/step.hpp"

namespace polhode {
namespace {

/// The flows of a harmonic oscillator, q̈ = −q.
struct Oscillator {
  double q, p;
  void drift(double t) { q += t * p; }
  void kick(double t) { p -= t * q; }
  /// Kicks with the force at q + 2ξh² f, which the gradient kick approximates [vanzon2008, Eq. 6].
  void kick(double t, double xi_h2, Gradient) { p -= t * (1 - 2 * xi_h2) * q; }
  void bath(double, StageNumber) {}
};

double trace(const Scheme& scheme, double h) {
  Oscillator a{1, 0}, b{0, 1};
  step(scheme, a, h);
  step(scheme, b, h);
  return a.q + b.p;
}

}  // namespace

double stability_limit(const Scheme& scheme) {
  constexpr double resolution = 1e-3, rounding = 1e-9;
  double h = resolution;
  while (std::abs(trace(scheme, h)) <= 2 + rounding && h < Scheme::max_stages) h += resolution;
  return h - resolution;
}

}  // namespace polhode
