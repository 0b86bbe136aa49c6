// SPDX-License-Identifier: MIT
#include "run/adviser/step_search.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace polhode;

namespace {

// A scheme with known R: a hᵖ, up to the stability limit `end` [fs], and never below `floor`.
struct KnownLaw {
  double a;
  int order;
  double end = 1e9, floor = 0;
  double ratio(double step) const { return std::hypot(a * std::pow(1000 * step, order), floor); }
};

// Six runs that scatter by 4 %.
AdviserPoint measured(const KnownLaw& scheme, const StepSearch& search, double step,
                      std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  AdviserPoint point{step, 1, std::vector<Outcome>(6), 0, true};
  for (Outcome& run : point.runs) {
    run.ratio = scheme.ratio(step) * std::exp(0.04 * normal(random));
    run.drift = 1e-5 * scheme.ratio(step) + 1e-9 * normal(random);
    if (1000 * step > scheme.end) run.failure = "it blew up";
  }
  point.bound = upper_bound(search.criterion.quality, point.runs);
  point.usable = !blew_up(point.runs);
  return point;
}

std::vector<AdviserPoint> searched(const KnownLaw& scheme, const StepSearch& search) {
  std::mt19937_64 random(2);
  std::vector<AdviserPoint> points;
  while (const auto step = next_step(search, points)) {
    double max_step = 0;
    for (const AdviserPoint& p : points)
      if (p.usable) max_step = std::max(max_step, p.step);
    if (max_step > 0) CHECK(*step < max_growth * max_step * (1 + 1e-12));
    points.push_back(measured(scheme, search, *step, random));
    std::sort(points.begin(), points.end(), [](auto& a, auto& b) { return a.step < b.step; });
    REQUIRE(points.size() <= 12);
  }
  return points;
}

}  // namespace

// R = 5·10⁻⁴ (h/fs)² is 0.5 % at 3.16 fs. With six runs that scatter by 4 % the bound is t(5) s
// √(7/6) = 11 % above the mean, with an uncertainty of half as much from the error of s: the step
// is 3 to 9 % shorter.
TEST_CASE("the step is the one whose bound equals the required R") {
  const KnownLaw scheme{5e-4, 2};
  const StepSearch search{{Quality::ratio, 0.005}, 2, 0.001};
  const FoundStep found = found_step(search, searched(scheme, search));
  CHECK(found.step > 0.91 * std::sqrt(10) / 1000);
  CHECK(found.step < 0.97 * std::sqrt(10) / 1000);
}

TEST_CASE("the result does not depend on the first step") {
  const KnownLaw scheme{5e-4, 2};
  for (const double first : {0.0001, 0.02}) {
    const StepSearch search{{Quality::ratio, 0.005}, 2, first};
    const FoundStep found = found_step(search, searched(scheme, search));
    CHECK(found.step > 0.90 * std::sqrt(10) / 1000);
    CHECK(found.step < 0.98 * std::sqrt(10) / 1000);
  }
}

// The fourth-order scheme is stable up to 5 fs, where R is 0.06 %: for 1 % the longest stable steps
// are the answer.
TEST_CASE("if stability is the limit, the step is below the stability limit") {
  const KnownLaw scheme{1e-6, 4, 5};
  const StepSearch search{{Quality::ratio, 0.01}, 4, 0.002};
  const FoundStep found = found_step(search, searched(scheme, search));
  CHECK(found.step > 0.004);
  CHECK(found.step < 0.005);
}

TEST_CASE("no step has an R below the floor") {
  const StepSearch search{{Quality::ratio, 1e-5}, 2, 0.001};
  CHECK(found_step(search, searched({5e-4, 2, 1e9, 1e-4}, search)).step == 0);
  CHECK(found_step(search, searched({5e-4, 2, 0}, search)).step == 0);  // no step is stable
}

// An energy drift of 10⁻⁵ R per ps is 10⁻⁸ at R = 10⁻³, at 1.41 fs; successive steps differ by a
// factor of 1.25.
TEST_CASE("a bound on the drift is met by trying a ladder of steps") {
  const StepSearch search{{Quality::drift, 1e-8}, 2, 0.0005};
  const double step = found_step(search, searched({5e-4, 2}, search)).step;
  CHECK(step > 0.0014142 / 1.25);
  CHECK(step < 0.0014142);
}

TEST_CASE("steps are rounded down to three digits") {
  CHECK(three_digits(0.00456789) == doctest::Approx(0.00456).epsilon(1e-12));
  CHECK(three_digits(0.01) == doctest::Approx(0.01).epsilon(1e-12));
}

// From one point the order determines where R meets the bound: R = 0.125 % at 1 fs is 0.5 % at
// twice the step at order 2, and at √2 times it at order 4; final runs begin at 0.7 of that.
TEST_CASE("the expected maximum step is where R extrapolated by the order equals the bound") {
  for (const auto& [order, expected] : {std::pair(2, 0.002), {4, 0.001 * std::sqrt(2.0)}}) {
    const auto shown_order = order;
    CAPTURE(shown_order);
    const StepSearch search{{Quality::ratio, 0.005}, order, 0.001};
    CHECK(max_expected_step(search, {}) == std::numeric_limits<double>::infinity());
    CHECK(!decides(search, {}, 0.001));  // nothing is known before the first
    AdviserPoint one{0.001, 1, std::vector<Outcome>(6), 0, true};
    for (Outcome& run : one.runs) run.ratio = 0.00125;
    CHECK(max_expected_step(search, {one}) == doctest::Approx(expected).epsilon(1e-12));
    CHECK(decides(search, {one}, 0.71 * expected));
    CHECK(!decides(search, {one}, 0.69 * expected));
    AdviserPoint end{1.1 * 0.001, 1, std::vector<Outcome>(6), 0, false};
    CHECK(max_expected_step(search, {one, end}) == end.step);
    CHECK(max_expected_step(search, {end}) == end.step);
  }
  const StepSearch search{
      {Quality::drift, 1e-8}, 2, 0.001};  // without a power law every run is final
  CHECK(max_expected_step(search, {}) == std::numeric_limits<double>::infinity());
  CHECK(decides(search, {}, 0.001));
}

// A bound of 0.5 of the required R becomes 0.9 of it at √1.8 = 1.34 times the step for order 2,
// more than the allowed 1.25, and at 1.8^(1/4) = 1.158 times it at order 4.
TEST_CASE("a step well below the bound is lengthened until it is close to it") {
  const double far = std::numeric_limits<double>::infinity();
  CHECK(*lengthened(0.004, 0.5, 2, far) == doctest::Approx(0.005).epsilon(1e-9));
  CHECK(*lengthened(0.004, 0.5, 4, far) == doctest::Approx(0.00463).epsilon(1e-9));
  CHECK(*lengthened(0.004, 0.79, 2, far) == doctest::Approx(0.00426).epsilon(1e-9));
  // A bound from 0.8 on is accepted, and one above the required R is no reason for a longer step.
  for (const double reached : {0.8, 0.95, 1.0, 1.3, 0.0})
    CHECK(!lengthened(0.004, reached, 2, far));
  // Half of the way to a step that is too long, in logarithms; no change if the gain is small.
  CHECK(*lengthened(0.004, 0.5, 2, 0.0044) == doctest::Approx(0.00419).epsilon(1e-9));
  CHECK(!lengthened(0.004, 0.5, 2, 0.0041));
  CHECK(!lengthened(0.004, 0.5, 40, far));  // 1.8^(1/40) = 1.015
}
