// SPDX-License-Identifier: MIT
#include "polhode/math/fit.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <vector>

using namespace polhode;

// By hand: mean 3, Σ (x − 3)² = 10, standard error √(10/4/5).
TEST_CASE("mean and standard error of five numbers") {
  const std::vector<double> x = {1, 2, 3, 4, 5};
  const Estimate m = mean(x);
  CHECK(m.value == 3);
  CHECK(m.error == doctest::Approx(std::sqrt(0.5)).epsilon(1e-15));
}

// Anscombe's first set, whose published regression is y = 3.00 + 0.500 x, standard error 0.118
// [anscombe1973].
TEST_CASE("slope and standard error of a published example") {
  const std::vector<double> x = {10, 8, 13, 9, 11, 14, 6, 4, 12, 7, 5};
  const std::vector<double> y = {8.04, 6.95, 7.58, 8.81, 8.33, 9.96, 7.24, 4.26, 10.84, 4.82, 5.68};
  const Estimate b = slope(x, y);
  CHECK(std::abs(b.value - 0.500) < 0.0005);  // as many digits as were published
  CHECK(std::abs(b.error - 0.118) < 0.0005);
}

// Student's t tables: t(9) = 3.250 and t(9) = 2.262 leave 1 % and 5 % on both sides.
TEST_CASE("the p-value of an estimate follows Student's t") {
  CHECK(100 * p_value({3.250, 1}, 9) == doctest::Approx(1).epsilon(1e-3));
  CHECK(20 * p_value({-2.262, 1}, 9) == doctest::Approx(1).epsilon(1e-3));
  CHECK(p_value({0, 0}, 9) == 1);
  CHECK(p_value({1, 0}, 9) == 0);
}

// Under the null hypothesis the p-value is uniform: of 2000 series, 5 % are significant at 5 %,
// within 4 binomial standard deviations, √(2000 × 0.05 × 0.95) = 9.7.
TEST_CASE("noise is significant at the stated rate") {
  std::mt19937_64 random(17);
  std::normal_distribution<double> normal;
  int significant = 0;
  for (int k = 0; k < 2000; ++k) {
    std::vector<double> x;
    for (int i = 0; i < 10; ++i) x.push_back(normal(random));
    if (p_value(mean(x), 9) < 0.05) ++significant;
  }
  CHECK(std::abs(significant - 100) < 39);
}

// Two points with errors e: the line goes through both; its slope errs by √2 e/Δx and its value at
// x = 0 by e √(x₁² + x₂²)/Δx. Equal points with unequal errors weigh as 1/e².
TEST_CASE("a weighted line has the errors of its points") {
  const std::vector<double> x{1, 3};
  const std::vector<Estimate> y{{2, 0.1}, {8, 0.1}};
  const Line line = weighted_line(x, y);
  CHECK(line.slope.value == doctest::Approx(3));
  CHECK(line.intercept.value == doctest::Approx(-1));
  CHECK(line.slope.error == doctest::Approx(std::sqrt(2.0) * 0.1 / 2));
  CHECK(line.intercept.error == doctest::Approx(0.1 * std::sqrt(10.0) / 2));
  const std::vector<double> twice{1, 3, 3};
  const std::vector<Estimate> unequal{{2, 0.1}, {8, 0.1}, {13, 0.2}};  // weights 4 to 1: 9
  CHECK(weighted_line(twice, unequal).slope.value == doctest::Approx(3.5));
}

// Tables of Student's t: 6.620 and 4.277 are exceeded in 0.27 % with 4 and 8 degrees of freedom.
TEST_CASE("the multiple of an error that chance exceeds as rarely as three standard deviations") {
  CHECK(three_sigma_quantile(4) == doctest::Approx(6.620).epsilon(1e-3));
  CHECK(three_sigma_quantile(8) == doctest::Approx(4.277).epsilon(1e-3));
  CHECK(three_sigma_quantile(1e6) == doctest::Approx(3).epsilon(1e-4));
  CHECK(three_sigma_quantile(0) == 3);
}

// Three points of error 1 with deviations 1/6, −1/3 and 1/6 of d from their line: χ² = d²/6 of one
// degree of freedom, whose root has Student's t distribution with those of the error.
TEST_CASE("deviations from a line have the p-value of Student's t for three points") {
  const std::vector<double> x{0, 1, 2};
  const std::vector<Estimate> y{{0, 1}, {5, 1}, {0, 1}};
  Line line = weighted_line(x, y);
  line.degrees_of_freedom = 6;
  CHECK(misfit_p_value(line, x, y) ==
        doctest::Approx(p_value({10 / std::sqrt(6.0), 1}, 6)).epsilon(1e-9));
  CHECK(misfit_p_value(line, std::vector<double>{0, 1}, y) == 1);
}
