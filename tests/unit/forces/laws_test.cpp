// SPDX-License-Identifier: MIT
#include "forces/laws/laws.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>

#include "forces/laws/lennard_jones.hpp"
#include "math/dual.hpp"
#include "polhode/base/units.hpp"

using namespace polhode;

// A polynomial of whole coefficients: its derivatives at the ends follow from Taylor's theorem.
// Approaching an end by d, |w − limit| must fall as d^(n+1), so halving d divides it by 2^(n+1);
// the next term changes the ratio by a relative O(d).
TEST_CASE("the switching function has its stated class at both ends") {
  for (const int n : {1, 2, 3}) {
    CAPTURE(n);
    const Switch<> w(0.8, 1.0, n);
    CHECK(w(0.8).w == 1.0);
    CHECK(w(0.5).w == 1.0);
    CHECK(w(0.5).slope == 0.0);
    CHECK(w(1.0).w == 0.0);
    CHECK(w(1.7).w == 0.0);
    CHECK(w(1.7).slope == 0.0);
    CHECK(w(0.9).w == doctest::Approx(0.5).epsilon(1e-13));
    const double d = 0.004;
    const double order_at_start = std::log2((1 - w(0.8 + d).w) / (1 - w(0.8 + d / 2).w));
    const double order_at_end = std::log2(w(1.0 - d).w / w(1.0 - d / 2).w);
    CHECK(std::abs(order_at_start - (n + 1)) < 0.05);
    CHECK(std::abs(order_at_end - (n + 1)) < 0.05);
  }
}

// The central second difference of w differs from its second derivative by δ²/12 times the fourth,
// which is at most 840 for the unit width (n = 3), and by the rounding of w, a few 1e-16, over δ².
TEST_CASE("the slope of the switching function has a slope itself") {
  const double delta = 1e-4;
  for (const int n : {1, 2, 3})
    for (double r = 0.8013; r < 0.9995 - delta; r += 0.0071) {
      CAPTURE(n);
      CAPTURE(r);
      const Switch<> w(0.8, 1.0, n);
      const double curvature = (w(r + delta).w - 2 * w(r).w + w(r - delta).w) / (delta * delta);
      const double bound = 840 / std::pow(0.2, 4) * delta * delta / 12 + 1e-15 / (delta * delta);
      CHECK(std::abs(w(Dual<double>(r, 1.0)).slope.slope - curvature) < bound);
    }
}

TEST_CASE("slopes and forces of the laws are the derivatives of their energies") {
  for (double r = 0.25; r < 1.1; r += 0.0371) {
    CAPTURE(r);
    const Dual<double> x(r, 1.0);
    for (const int n : {1, 2, 3}) {
      const auto w = Switch<>(0.8, 1.0, n)(x);
      CHECK(w.slope.value == doctest::Approx(w.w.slope).epsilon(1e-12));
      if (r < 0.8 || r > 1.0) CHECK(w.slope.slope == 0.0);
    }
    const auto lj = LennardJones<>{1.1e-3, 0.9e-6}(InversePowers<Dual<double>>(x * x), x * x);
    CHECK(lj.s.value == doctest::Approx(-lj.u.slope / r).epsilon(1e-13));
    for (const double dielectric : {1.0, 78.5, double(INFINITY)}) {
      const auto rf =
          ReactionField<>::of(dielectric, 1.0)(InversePowers<Dual<double>>(x * x), x * x);
      CHECK(rf.s.value == doctest::Approx(-rf.u.slope / r).epsilon(1e-12));
    }
  }
}

// At the cutoff the reaction field's energy vanishes by definition of c, and for an infinite
// dielectric so does the force: 1/r² = 2 k r with k = 1/(2 r_c³).
TEST_CASE("the reaction field vanishes at the cutoff") {
  const double rc = 0.9;
  const auto metal = ReactionField<>::of(INFINITY, rc)(InversePowers<double>(rc * rc), rc * rc);
  CHECK(std::abs(metal.u) < 1e-15);
  CHECK(std::abs(metal.s) < 1e-15);
  const auto vacuum = ReactionField<>::of(1.0, rc)(InversePowers<double>(0.25), 0.25);
  CHECK(vacuum.u == doctest::Approx(1 / 0.5 - 1 / rc).epsilon(1e-15));
}

// With one term, the textbook shift in r is made in r²: erfc(α r)/r minus its value at a and its
// slope there with respect to y, a/2 (erfc(x)/a² + 2 α/√π e^(−x²)/a) with x = α a. Powers of y left
// out are below 1e-10/a for x ≤ 2.4.
TEST_CASE("the damped shifted force is erfc(α r)/r minus its value and slope at the cutoff") {
  const double a = 0.9;
  for (const double x : {0.0, 1.0, 1.8, 2.4}) {
    CAPTURE(x);
    const double alpha = x / a, value = std::erfc(x) / a,
                 slope = value / 2 + alpha / std::sqrt(units::pi) * std::exp(-x * x);
    const SmoothPolynomial law = damped_shifted_force(a, alpha, 1);
    for (double r = 0.05; r < a; r += 0.0371) {
      const double y = 1 - r * r / (a * a);
      const double expected = std::erfc(alpha * r) / r - value - slope * y;
      CHECK(std::abs(law.pair(r).u - expected) < 1e-10 / a);
      // −u'/r by a difference of fourth order
      const double h = 1e-3 * r;
      const auto u = [&](double c) { return law.pair(r + c * h).u; };
      if (r + 2 * h < a)
        CHECK(law.pair(r).s ==
              doctest::Approx(-(8 * (u(1) - u(-1)) - (u(2) - u(-2))) / (12 * h * r)).epsilon(1e-9));
    }
  }
}

// As for the switching function, by Taylor's theorem: |u| falls as d^(n+1) at a distance d from the
// cutoff.
TEST_CASE("the damped shifted force has its stated class at the cutoff") {
  for (const double alpha : {0.0, 2.0, 3.0})
    for (const int n : {1, 2, 3}) {
      CAPTURE(n);
      const SmoothPolynomial law = damped_shifted_force(1.0, alpha, n);
      const double d = 1e-3;
      CHECK(std::abs(std::log2(law.pair(1 - d).u / law.pair(1 - d / 2).u) - (n + 1)) < 0.02);
      CHECK(law.pair(1.0).u == 0);
      CHECK(law.pair(1.3).s == 0);
    }
}
