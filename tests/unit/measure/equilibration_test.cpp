// SPDX-License-Identifier: MIT
// The end of equilibration, against values of the program red 2026 on the same series
// (detect_equilibration_window, method "min_sse", Bartlett window of √n lags).
#include "measure/equilibration.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "polhode/measure/energy_statistics.hpp"

using namespace polhode;

namespace {

/// An exponential approach under a bounded disturbance.
std::vector<double> series(int length, double time, double amplitude) {
  std::vector<double> x;
  for (int t = 0; t < length; ++t)
    x.push_back(amplitude * std::exp(-t / time) + std::sin(0.37 * t * t) +
                0.5 * std::sin(0.11 * t));
  return x;
}

/// A stationary series of unit variance with an autocorrelation of correlation^k.
std::vector<double> correlated(std::mt19937_64& random, double correlation) {
  constexpr int length = 120;
  std::normal_distribution<double> normal;
  std::vector<double> x;
  double now = normal(random);
  for (int t = 0; t < length; ++t) {
    x.push_back(now);
    now = correlation * now + std::sqrt(1 - correlation * correlation) * normal(random);
  }
  return x;
}

double mean_square(const std::vector<double>& x, std::size_t from) {
  double sum = 0;
  for (std::size_t t = from; t < x.size(); ++t) sum += x[t] * x[t];
  return sum / static_cast<double>(x.size() - from);
}

}  // namespace

TEST_CASE("the end of equilibration and the error of the mean are those of red") {
  struct Case {
    int length;
    double time, amplitude;
    std::size_t start;
    double error;
  };
  for (const Case& c : {Case{200, 20, 5, 34, 0.12769589796276754},
                        {120, 8, -3, 10, 0.12498138538141527},
                        {400, 60, 2, 79, 0.0918882195417298},
                        {50, 10, 0, 20, 0.12524802802009025}}) {
    CAPTURE(c.length);
    const Equilibration found = equilibration(series(c.length, c.time, c.amplitude));
    CHECK(found.start == c.start);
    CHECK(found.error == doctest::Approx(c.error).epsilon(1e-10));
  }
}

TEST_CASE("a short series is kept whole") {
  CHECK(equilibration(std::array{9.0, 0.0, 0.0}).start == 0);
  CHECK(equilibration({}).start == 0);
}

TEST_CASE("equilibrium starts at the transient, and at once in a stationary series") {
  // With a transient of several standard deviations the start is that of red.
  CHECK(equilibrium_start(series(200, 20, 5)) == 34);
  CHECK(equilibrium_start(series(400, 60, 2)) == 79);

  // Stationary series with autocorrelations of 0.5^k and 0.75^k. At most 2 % lose samples, and
  // less than 1 % lose the larger half, after which a measurement would be extended. The bounds
  // are three standard deviations of a binomial number above: n p + 3 √(n p). The mean variance of
  // what is kept differs from the variance of the whole series by less than 2 %.
  constexpr int runs = 400;
  for (const double correlation : {0.5, 0.75}) {
    CAPTURE(correlation);
    std::mt19937_64 random(1);
    int discarded = 0, larger_half = 0;
    double kept = 0, all = 0;
    for (int run = 0; run < runs; ++run) {
      const std::vector<double> x = correlated(random, correlation);
      const std::size_t start = equilibrium_start(x);
      discarded += start > 0;
      larger_half += 2 * start > x.size();
      kept += mean_square(x, start) / runs;
      all += mean_square(x, 0) / runs;
    }
    CHECK(discarded <= 16);
    CHECK(larger_half <= 10);
    CHECK(kept == doctest::Approx(all).epsilon(0.02));
  }
}

// Over 120 samples with an autocorrelation of 0.5^k, a difference of both halves of three standard
// deviations is 3/√(3 · 2/60) = 9.5 standard errors of this difference. The start with the smallest
// error may lie behind the jump.
TEST_CASE("a jump in the middle of a series is found") {
  constexpr int runs = 100;
  std::mt19937_64 random(2);
  int found = 0;
  for (int run = 0; run < runs; ++run) {
    std::vector<double> x = correlated(random, 0.5);
    for (std::size_t t = 0; t < x.size() / 2; ++t) x[t] += 3;
    const std::size_t start = equilibrium_start(x);
    found += start > 50;
  }
  CHECK(found >= 85);
}

TEST_CASE("a run knows where its potential energy or its volume became stationary") {
  // Both approach their means with a time constant of 200 of 4000 samples, under a disturbance of
  // unit size. Blocks have 100 to 200 samples, so the start is where exp(-t/200) times the first
  // deviation falls below the noise of such a block, about 0.2: after 3.9 time constants. It is
  // found within two of the largest blocks.
  for (const bool volume : {false, true}) {
    CAPTURE(volume);
    EnergyStatistics statistics;
    for (int t = 0; t < 4000; ++t) {
      const double x = 10 * std::exp(-t / 200.0) + std::sin(0.37 * t * t);
      statistics.add(
          {.time = 0.1 * t, .van_der_waals = volume ? 0 : x, .volume = volume ? 100 + x : 100});
    }
    CHECK(statistics.samples_before_equilibrium() > 780 - 400);
    CHECK(statistics.samples_before_equilibrium() < 780 + 400);
  }
}
