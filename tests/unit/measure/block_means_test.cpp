// SPDX-License-Identifier: MIT
#include "polhode/measure/block_means.hpp"

#include <doctest/doctest.h>

#include <array>

#include "polhode/math/random.hpp"

using namespace polhode;

TEST_CASE("time blocks store a stream of any length") {
  for (const int length : {1, 39, 41, 1000, 12345}) {
    TimeBlocks blocks;
    Random random(7);
    double sum = 0;
    for (int k = 0; k < length; ++k) {
      const double x = random.normal();
      sum += x;
      blocks.add(std::array{x, 1.0});
    }
    const BlockMeans means = blocks.means();
    CAPTURE(length);
    CHECK(means.blocks().size() <= 40);
    if (length > 20) CHECK(means.blocks().size() >= 20);
    CHECK(means.mean()[0] == doctest::Approx(sum / length).epsilon(1e-12));
    CHECK(means.mean()[1] == doctest::Approx(1));
  }
}
