// SPDX-License-Identifier: MIT
#include "polhode/measure/block_means.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "polhode/math/random.hpp"

using namespace polhode;

// Blocks of equal weight: the error of a mean is that of the blocks' means, and the jackknife of a
// linear statistic gives the same.
TEST_CASE("means of blocks and the jackknife agree where they must") {
  const BlockMeans means({{2, {2.0}}, {2, {4.0}}, {2, {8.0}}, {2, {14.0}}});  // 1, 2, 4, 7
  const Estimate direct = means.estimates().front();
  CHECK(direct.value == doctest::Approx(3.5));
  CHECK(direct.error == doctest::Approx(std::sqrt(21.0 / 3 / 4)).epsilon(1e-14));
  const Estimate jackknife = means.estimate([](std::span<const double> m) { return 3 * m[0]; });
  CHECK(jackknife.value == doctest::Approx(10.5));
  CHECK(jackknife.error == doctest::Approx(3 * direct.error).epsilon(1e-14));
}

// White noise: the error is σ/√n however the stream was cut; 20 to 40 blocks know it to 1/√(2 · 19)
// = 16 %, and four times that is allowed.
TEST_CASE("blocks of time hold any length, and tell the error of white noise") {
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
    if (length >= 1000)
      CHECK(means.estimates()[0].error == doctest::Approx(1 / std::sqrt(length)).epsilon(0.64));
  }
}
