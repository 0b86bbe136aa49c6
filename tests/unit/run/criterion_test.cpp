// SPDX-License-Identifier: MIT
#include "polhode/run/adviser/criterion.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace polhode;

namespace {

// Eight runs, log R = log 0.004 ± d: their standard deviation is d √(8/7), and the bound of a new
// run is t(7) d √(8/7) √(9/8) = t(7) d √(9/7) above the mean, with t(7) = 2.3646 at 97.5 %.
constexpr double t7 = 2.364624251592785;

std::vector<Outcome> scattered_ratios(double d) {
  std::vector<Outcome> runs(8);
  for (std::size_t r = 0; r < runs.size(); ++r)
    runs[r].ratio = 0.004 * std::exp(r % 2 == 0 ? d : -d);
  return runs;
}

}  // namespace

TEST_CASE(
    "part of the length may meet a bound if R is constant and its scatter falls with the square "
    "root") {
  const double d = 0.06;
  const std::vector<Outcome> runs = scattered_ratios(d);
  for (const double part : {1.0 / 9, 1.0 / 3, 1.0}) {
    CAPTURE(part);
    const double bound = 0.004 * std::exp(t7 * std::sqrt(part) * d * std::sqrt(9.0 / 7));
    CHECK(optimistic_bound(runs, part) == doctest::Approx(bound).epsilon(1e-9));
    CHECK(may_meet({Quality::ratio, bound * (1 + 1e-9)}, runs, part));
    CHECK(!may_meet({Quality::ratio, bound * (1 - 1e-9)}, runs, part));
  }
  // The bound is for the whole length.
  const double whole = upper_bound(Quality::ratio, runs);
  CHECK(may_meet({Quality::ratio, whole}, runs, 1));
  CHECK(!may_meet({Quality::ratio, whole * (1 - 1e-12)}, runs, 1));
}

TEST_CASE("a bias is bounded only where R is small enough for its prediction") {
  std::vector<Outcome> runs = scattered_ratios(0);
  for (Outcome& run : runs) run.energy_bias = 0.001;
  const Criterion criterion{Quality::energy_bias, 0.01};
  CHECK(upper_bound(criterion, runs) == upper_bound(Quality::energy_bias, runs));
  for (Outcome& run : runs) run.ratio = 0.06;  // a run warns above 5 %
  CHECK(upper_bound(criterion, runs) == doctest::Approx(0.01 * 0.06 / 0.05));
  CHECK(upper_bound({Quality::drift, 0.01}, runs) == upper_bound(Quality::drift, runs));
}

// n runs, all but one equal: that one is δ above them, 1 − 1/n above the mean of the logarithms,
// and no set of n has a larger deviation in units of its scatter δ/√n. The bound is 1/n + t √(n +
// 1)/n times δ above the others, for n = 8 by 1/8 + 3 t(7)/8 = 1.0117.
TEST_CASE("one run above the required R is enough to reject every set that contains it") {
  const double d = 0.1;
  for (std::size_t n = 2; n <= 8; ++n) {
    CAPTURE(n);
    std::vector<Outcome> runs(n);
    for (Outcome& run : runs) run.ratio = 0.004;
    runs.front().ratio = 0.004 * std::exp(d);
    const double above = std::log(upper_bound(Quality::ratio, runs) / 0.004) / d;
    CHECK(above > 1);
    if (n == 8) CHECK(above == doctest::Approx((1 + 3 * t7) / 8).epsilon(1e-9));
  }
}

TEST_CASE("parts of runs show only blow-ups, not drifts or biases") {
  std::vector<Outcome> runs = scattered_ratios(0.1);
  for (const Quality quality : {Quality::drift, Quality::temperature_bias}) {
    CHECK(may_meet({quality, 1e-9}, runs, 1.0 / 3));
    runs[3].failure = "it blew up";
    CHECK(!may_meet({quality, 1e9}, runs, 1.0 / 3));
    runs[3].failure.clear();
  }
}
