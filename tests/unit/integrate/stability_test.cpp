// SPDX-License-Identifier: MIT
#include "integrate/stability.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "polhode/integrate/scheme_text.hpp"
#include "polhode/integrate/step.hpp"

using namespace polhode;

namespace {

// The largest energy of an oscillator over many steps; its frequency is 1 and it starts with 1/2.
double max_energy(const Scheme& scheme, double h) {
  struct Oscillator {
    double q = 1, p = 0;
    void drift(double t) { q += t * p; }
    void kick(double t) { p -= t * q; }
    void kick(double t, double xi_h2, Gradient) {
      constexpr double lambda = 1e-3;  // by finite difference, exact for a linear force
      const double displaced = q - 2 * xi_h2 * lambda * q;
      p += t * (-q + (q - displaced) / lambda);
    }
  } flows;
  double largest = 0;
  for (int n = 0; n < 20000; ++n) {
    step(scheme, flows, h);
    largest = std::max(largest, (flows.q * flows.q + flows.p * flows.p) / 2);
  }
  return largest;
}

}  // namespace

TEST_CASE("Verlet is stable up to ω h = 2") {
  // To the resolution of the search.
  CHECK(stability_limit(scheme_of("velocity-verlet")) == doctest::Approx(2).epsilon(1e-3));
  CHECK(stability_limit(scheme_of("position-verlet")) == doctest::Approx(2).epsilon(1e-3));
}

TEST_CASE("an oscillator stays bounded below the stability limit and not above") {
  for (const char* name : {"velocity-verlet", "hoa2", "bcss3", "gier4", "gier4-fd"}) {
    CAPTURE(name);
    const Scheme scheme = scheme_of(name);
    const double limit = stability_limit(scheme);
    CHECK(limit > 1);
    // Close to the limit the orbit is an ellipse whose axes differ by √(1 − (h/limit)²) or so.
    CHECK(max_energy(scheme, 0.98 * limit) < 100);
    CHECK(max_energy(scheme, 1.02 * limit) > 1e6);
  }
}
