// SPDX-License-Identifier: MIT
// Intervals of measured properties.
#include <doctest/doctest.h>

#include <cmath>

#include "polhode/math/random.hpp"
#include "polhode/run/properties/measure.hpp"
#include "run/properties/property.hpp"

using namespace polhode;

// The variance of 32 normal numbers has an error that is proportional to it. In 4000 samples, an
// interval symmetric in the logarithm contains the true variance in 68 and 95 % up to terms of
// order 1/32, below 1.5 % here, and up to three errors of a binomial number. The symmetric interval
// contains it in 91 %.
TEST_CASE("intervals of a variance contain it as often as stated") {
  constexpr int samples = 4000, n = 32;
  Random random(7);
  for (const double probability : {0.68, 0.95}) {
    int contained = 0, contained_by_symmetric = 0;
    for (int k = 0; k < samples; ++k) {
      double sum = 0, squares = 0;
      for (int i = 0; i < n; ++i) {
        const double x = random.normal();
        sum += x, squares += x * x;
      }
      const double variance = (squares - sum * sum / n) / (n - 1);
      const SeriesEstimate value{variance, variance * std::sqrt(2.0 / (n - 1)), Known::yes, n - 1};
      const auto contains = [&](const char* name) {
        const auto found =
            MeasuredProperty{.request = {&property(name)}, .value = value}.interval(probability);
        return found->front() < 1 && 1 < found->back();
      };
      contained += contains("compressibility");
      contained_by_symmetric += contains("density");
    }
    const double error = std::sqrt(probability * (1 - probability) / samples);
    CHECK(std::abs(contained / double(samples) - probability) < 3 * error + 0.015);
    if (probability > 0.9) CHECK(contained_by_symmetric / double(samples) < 0.93);
  }
}
