// SPDX-License-Identifier: MIT
// Elapsed times: ordered and additive, whatever the machine does.
#include "base/stopwatch.hpp"

#include <doctest/doctest.h>

using namespace polhode;

TEST_CASE("laps of a stopwatch add up to the whole") {
  const Stopwatch whole;
  Stopwatch laps;
  double sum = 0, work = 0;
  for (int n = 0; n < 100; ++n) {
    work += seconds_of([&] { CHECK(laps.seconds() >= 0); });
    sum += laps.lap();
  }
  constexpr double rounding = 1e-9;  // of 100 sums of times of microseconds [s]
  CHECK(work <= sum + rounding);
  CHECK(sum <= whole.seconds() + rounding);
  CHECK(laps.seconds() <= whole.seconds());
}
