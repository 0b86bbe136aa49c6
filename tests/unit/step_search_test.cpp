// SPDX-License-Identifier: MIT
#include "polhode/run/adviser/step_search.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace polhode;

namespace {

// A scheme whose R is known: a hᵖ, up to `end` [fs], and never below `floor`.
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
    double longest = 0;
    for (const AdviserPoint& p : points)
      if (p.usable) longest = std::max(longest, p.step);
    if (longest > 0) CHECK(*step < max_growth * longest * (1 + 1e-12));
    points.push_back(measured(scheme, search, *step, random));
    std::sort(points.begin(), points.end(), [](auto& a, auto& b) { return a.step < b.step; });
    REQUIRE(points.size() <= 12);
  }
  return points;
}

}  // namespace

// R = 5·10⁻⁴ (h/fs)² is 0.5 % at 3.16 fs. With six runs that scatter by 4 % the bound lies t(5) s
// √(7/6) = 11 % above the mean, give or take half as much for the error of s: the step is 3 to 9 %
// shorter.
TEST_CASE("the step is the one whose bound is the R asked for") {
  const KnownLaw scheme{5e-4, 2};
  const StepSearch search{{Quality::ratio, 0.005}, 2, 0.001};
  const FoundStep found = found_step(search, searched(scheme, search));
  CHECK(found.step > 0.91 * std::sqrt(10) / 1000);
  CHECK(found.step < 0.97 * std::sqrt(10) / 1000);
}

TEST_CASE("a first step that is far too long or too short does not matter") {
  const KnownLaw scheme{5e-4, 2};
  for (const double first : {0.0001, 0.02}) {
    const StepSearch search{{Quality::ratio, 0.005}, 2, first};
    const FoundStep found = found_step(search, searched(scheme, search));
    CHECK(found.step > 0.90 * std::sqrt(10) / 1000);
    CHECK(found.step < 0.98 * std::sqrt(10) / 1000);
  }
}

// Fourth order ends at 5 fs, where R is 0.06 %: for 1 % the longest steps that run are the answer.
TEST_CASE("where stability ends first, the step lies before its end") {
  const KnownLaw scheme{1e-6, 4, 5};
  const StepSearch search{{Quality::ratio, 0.01}, 4, 0.002};
  const FoundStep found = found_step(search, searched(scheme, search));
  CHECK(found.step > 0.004);
  CHECK(found.step < 0.005);
}

TEST_CASE("below a floor of R there is no step") {
  const StepSearch search{{Quality::ratio, 1e-5}, 2, 0.001};
  CHECK(found_step(search, searched({5e-4, 2, 1e9, 1e-4}, search)).step == 0);
  CHECK(found_step(search, searched({5e-4, 2, 0}, search)).step == 0);  // no step is stable
}

// A drift of 10⁻⁵ R per ps is 10⁻⁸ at R = 10⁻³, at 1.41 fs; the ladder's rungs lie 1.25 apart.
TEST_CASE("a drift is met on a ladder") {
  const StepSearch search{{Quality::drift, 1e-8}, 2, 0.0005};
  const double step = found_step(search, searched({5e-4, 2}, search)).step;
  CHECK(step > 0.0014142 / 1.25);
  CHECK(step < 0.0014142);
}

TEST_CASE("steps are shortened to three digits") {
  CHECK(three_digits(0.00456789) == doctest::Approx(0.00456).epsilon(1e-12));
  CHECK(three_digits(0.01) == doctest::Approx(0.01).epsilon(1e-12));
}

// From one point the law of the order says where R meets the bound: R = 0.125 % at 1 fs is 0.5 % at
// twice the step at order 2, and at √2 times it at order 4; runs decide from 0.7 of that on.
TEST_CASE("the longest step to be expected is where R meets the bound by the order") {
  for (const auto& [order, expected] : {std::pair(2, 0.002), {4, 0.001 * std::sqrt(2.0)}}) {
    CAPTURE(order);
    const StepSearch search{{Quality::ratio, 0.005}, order, 0.001};
    CHECK(max_expected_step(search, {}) == std::numeric_limits<double>::infinity());
    CHECK(!decides(search, {}, 0.001));  // nothing is known of the first
    AdviserPoint one{0.001, 1, std::vector<Outcome>(6), 0, true};
    for (Outcome& run : one.runs) run.ratio = 0.00125;
    CHECK(max_expected_step(search, {one}) == doctest::Approx(expected).epsilon(1e-12));
    CHECK(decides(search, {one}, 0.71 * expected));
    CHECK(!decides(search, {one}, 0.69 * expected));
    AdviserPoint end{1.1 * 0.001, 1, std::vector<Outcome>(6), 0, false};
    CHECK(max_expected_step(search, {one, end}) == end.step);
    CHECK(max_expected_step(search, {end}) == end.step);
  }
  const StepSearch search{{Quality::drift, 1e-8}, 2, 0.001};  // without a law every run decides
  CHECK(max_expected_step(search, {}) == std::numeric_limits<double>::infinity());
  CHECK(decides(search, {}, 0.001));
}

// A bound of 0.5 of what was asked is 0.9 of it at √1.8 = 1.34 times the step at order 2, more than
// the 1.25 allowed at once, and at 1.8^(1/4) = 1.158 times it at order 4.
TEST_CASE("a step whose bound leaves room is lengthened to where little is left") {
  const double far = std::numeric_limits<double>::infinity();
  CHECK(*lengthened(0.004, 0.5, 2, far) == doctest::Approx(0.005).epsilon(1e-9));
  CHECK(*lengthened(0.004, 0.5, 4, far) == doctest::Approx(0.00463).epsilon(1e-9));
  CHECK(*lengthened(0.004, 0.79, 2, far) == doctest::Approx(0.00426).epsilon(1e-9));
  // What lies from 0.8 on is as wanted, and a bound that was broken is no reason for a longer step.
  for (const double reached : {0.8, 0.95, 1.0, 1.3, 0.0})
    CHECK(!lengthened(0.004, reached, 2, far));
  // Half of the way to a step that is too long, in logarithms; nothing where that is hardly a gain.
  CHECK(*lengthened(0.004, 0.5, 2, 0.0044) == doctest::Approx(0.00419).epsilon(1e-9));
  CHECK(!lengthened(0.004, 0.5, 2, 0.0041));
  CHECK(!lengthened(0.004, 0.5, 40, far));  // 1.8^(1/40) = 1.015
}
