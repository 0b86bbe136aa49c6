// SPDX-License-Identifier: MIT
#include "polhode/math/random.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <vector>

using namespace polhode;

TEST_CASE("Philox gives its authors' reference numbers") {
  // Known answers of Random123 [salmon2011]: zeros, ones, and digits of pi.
  using Words = std::array<std::uint32_t, 4>;
  CHECK(philox({0, 0, 0, 0}, {0, 0}) == Words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8});
  CHECK(philox({~0u, ~0u, ~0u, ~0u}, {~0u, ~0u}) ==
        Words{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd});
  CHECK(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}) ==
        Words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1});
}

TEST_CASE("streams of one seed differ and are reproducible") {
  Random a(1, 0), again(1, 0), other(1, 1), reseeded(2, 0);
  for (int k = 0; k < 100; ++k) {
    const auto bits = a.bits();
    CHECK(bits == again.bits());
    CHECK(bits != other.bits());
    CHECK(bits != reseeded.bits());
  }
}

// Sums of seed and index would be equal along diagonals: (1, 1) and (2, 0). Of 4 · 10⁶ derived
// seeds two agree by chance with (4e6)²/2/2⁶⁴ = 4e-7.
TEST_CASE("derived seeds of consecutive seeds and indices are all different") {
  std::vector<std::uint64_t> all;
  for (std::uint64_t seed = 0; seed < 2000; ++seed)
    for (std::uint64_t index = 0; index < 2000; ++index) all.push_back(derived_seed(seed, index));
  for (std::uint64_t seed = 0; seed < 2000; ++seed) all.push_back(seed);  // those of run files
  std::sort(all.begin(), all.end());
  CHECK(std::adjacent_find(all.begin(), all.end()) == all.end());
  // Half of the bits change from one index to the next: 64 · 4000 fair coins, five standard errors.
  int changed = 0;
  for (std::uint64_t k = 0; k < 4000; ++k)
    changed += std::popcount(derived_seed(1, k) ^ derived_seed(1, k + 1));
  CHECK(std::abs(changed - 32 * 4000) < 5 * std::sqrt(64 * 4000) / 2);
}

TEST_CASE("normal deviates have the moments of their distribution") {
  // For n deviates the mean has the standard error 1/√n, the variance √(2/n), the mean fourth power
  // √((105 − 9)/n); five of each, at a fixed seed.
  constexpr int n = 100000;
  Random random(3);
  double m1 = 0, m2 = 0, m4 = 0;
  for (int k = 0; k < n; ++k) {
    const double x = random.normal();
    m1 += x / n, m2 += x * x / n, m4 += x * x * x * x / n;
  }
  CHECK(std::abs(m1) < 5 * std::sqrt(1.0 / n));
  CHECK(std::abs(m2 - 1) < 5 * std::sqrt(2.0 / n));
  CHECK(std::abs(m4 - 3) < 5 * std::sqrt(96.0 / n));
}

TEST_CASE("orientations have no preferred direction") {
  // Each element of S has mean 0 and variance 1/3 over the rotations; its square has variance
  // 1/5 − 1/9. Five standard errors.
  constexpr int n = 20000;
  Random random(4);
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t k = 0; k < 3; ++k) {
      double m1 = 0, m2 = 0;
      for (int i = 0; i < n; ++i) {
        const double s = matrix_S(random.orientation())[row][k];
        m1 += s / n, m2 += s * s / n;
      }
      CHECK(std::abs(m1) < 5 * std::sqrt(1.0 / 3 / n));
      CHECK(std::abs(m2 - 1.0 / 3) < 5 * std::sqrt((1.0 / 5 - 1.0 / 9) / n));
    }
}
