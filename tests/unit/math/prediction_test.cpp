// SPDX-License-Identifier: MIT
#include "math/prediction.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <vector>

using namespace polhode;

// Student's t tables: t(0.975; 7) = 2.365, t(0.975; 4) = 2.776. Of 1 to 5: mean 3, s = √2.5.
TEST_CASE("prediction bounds of five numbers") {
  CHECK(t_quantile(0.975, 7) == doctest::Approx(2.365).epsilon(3e-4));
  const std::vector<double> x = {1, 2, 3, 4, 5};
  const double t = t_quantile(0.975, 4), s = std::sqrt(2.5);
  CHECK(t == doctest::Approx(2.776).epsilon(3e-4));
  CHECK(prediction_bound(x, 0.975) == doctest::Approx(3 + t * s * std::sqrt(1.2)).epsilon(1e-14));
  CHECK(size_bound(x, 0.975) == doctest::Approx(3 + t * s * std::sqrt(0.2)).epsilon(1e-14));
  CHECK(size_bound(std::vector<double>{-1, -2, -3, -4, -5}, 0.975) == size_bound(x, 0.975));
  CHECK(std::isinf(prediction_bound(std::vector<double>{1}, 0.975)));
}

// The bound of eight values exceeds a ninth in 97.5 of 100 cases: in 20000 series within 4 binomial
// standard deviations, √(20000 × 0.975 × 0.025) = 22. Without √(1 + 1/n) it would do so in 96.95 of
// 100, 5 deviations less, and with the normal distribution's 1.96 in place of t in 95.5.
TEST_CASE("a further value is below the prediction bound at the stated rate") {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  int kept = 0;
  for (int k = 0; k < 20000; ++k) {
    std::vector<double> x;
    for (int i = 0; i < 8; ++i) x.push_back(normal(random));
    if (normal(random) < prediction_bound(x, 0.975)) ++kept;
  }
  CHECK(std::abs(kept - 19500) < 88);
}

// Satterthwaite: errors of equal size add their degrees of freedom, and one that dominates keeps
// its own.
TEST_CASE("degrees of freedom of an error that has several parts") {
  const ErrorPart both = summed({{0.3, 2}, {0.3, 2}});
  CHECK(both.error == doctest::Approx(0.3 * std::sqrt(2.0)).epsilon(1e-14));
  CHECK(both.degrees_of_freedom == doctest::Approx(4).epsilon(1e-14));
  CHECK(summed({{1, 2}, {1e-6, 50}}).degrees_of_freedom == doctest::Approx(2).epsilon(1e-9));
  CHECK(confidence_half_width(both) == doctest::Approx(2.776 * 0.3 * std::sqrt(2.0)).epsilon(3e-4));
  CHECK(confidence_half_width(summed({{0, 2}})) == 0);
  CHECK(std::isinf(confidence_half_width({0.3, 0})));
}
