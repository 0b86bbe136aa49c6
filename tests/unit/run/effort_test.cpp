// SPDX-License-Identifier: MIT
#include "run/progress_pace.hpp"

#include <doctest/doctest.h>

using namespace polhode;

TEST_CASE("the fraction of an effort is 1 only when all that is expected is done") {
  Effort effort;
  CHECK(effort.fraction() == 0);
  effort.expect(10);
  effort.add(4);
  CHECK(effort.fraction() == doctest::Approx(0.4));
  effort.add(6);
  CHECK(effort.fraction() == 1);
  effort.expect(30);  // a step was rejected
  CHECK(effort.fraction() == doctest::Approx(0.25));
  effort.add(60);  // more than was expected
  CHECK(effort.fraction() == 1);
}
