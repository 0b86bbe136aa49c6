// SPDX-License-Identifier: MIT
#include "measure/autocorrelation_time.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <span>
#include <vector>

#include "polhode/math/fit.hpp"
#include "polhode/math/random.hpp"

using namespace polhode;

namespace {

/// x ← a x + ξ √(1 − a²): ρ(t) = aᵗ, so τ = 1/2 + a/(1 − a).
std::vector<double> autoregressive(double a, std::size_t length, std::uint64_t stream) {
  Random random(7, stream);
  std::vector<double> series;
  double x = random.normal();
  for (std::size_t i = 0; i < length; ++i) {
    series.push_back(3 + 2 * x);
    x = a * x + std::sqrt(1 - a * a) * random.normal();
  }
  return series;
}

}  // namespace

TEST_CASE("autocorrelation times and their errors are calibrated for an AR(1) process") {
  for (const double a : {0.0, 0.5, 0.8, 0.95}) {
    CAPTURE(a);
    const double exact = 0.5 + a / (1 - a);
    std::vector<double> values, errors;
    for (std::uint64_t stream = 0; stream < 200; ++stream) {
      const auto tau = autocorrelation_time(autoregressive(a, 4000, stream));
      REQUIRE(tau);
      values.push_back(tau->value);
      errors.push_back(tau->error);
    }
    const Estimate found = mean(values);
    // The window leaves out a part of the sum: at S = 1.5 e^(-W/τ) of it, where W is a few τ, and
    // the number of samples, 100 τ and more, makes W at least 3 τ: below 5 %.
    CHECK(found.value == doctest::Approx(exact).epsilon(0.05 + 3 * found.error / exact));
    // The scatter of 200 values is known to 5 %, and the error of a single one is first order in
    // W/n.
    const double scatter = found.error * std::sqrt(200.0);
    CHECK(mean(errors).value / scatter > 0.75);
    CHECK(mean(errors).value / scatter < 1.35);
  }
}

TEST_CASE("the mean of short series is corrected: their autocorrelation time is not too short") {
  std::vector<double> values;
  for (std::uint64_t stream = 0; stream < 400; ++stream)
    if (const auto tau = autocorrelation_time(autoregressive(0.8, 120, 1000 + stream)))
      values.push_back(tau->value);
  const Estimate found = mean(values);
  CHECK(values.size() > 360);
  // Exact 4.5, 27 times shorter than the series. Without the correction of (2W + 1)/n, W about 15,
  // it would be a quarter less; series whose window does not close are left out.
  CHECK(found.value > 0.85 * 4.5);
  CHECK(found.value < 1.15 * 4.5);
}

// Exact 9.5, and runs of ten times that. About the mean of each run it would be a third less, and
// runs whose window does not close are often without one.
TEST_CASE("short runs of one process have its autocorrelation time about their common mean") {
  constexpr double a = 0.9, exact = 0.5 + a / (1 - a);
  constexpr int trials = 300, together = 4;
  std::vector<double> values, errors;
  for (std::uint64_t trial = 0; trial < trials; ++trial) {
    std::vector<std::vector<double>> series;
    for (std::uint64_t r = 0; r < together; ++r)
      series.push_back(autoregressive(a, 95, 5000 + together * trial + r));
    const std::vector<std::span<const double>> runs(series.begin(), series.end());
    if (const auto tau = autocorrelation_time(runs))
      values.push_back(tau->value), errors.push_back(tau->error);
  }
  CHECK(values.size() > 0.95 * trials);
  const Estimate found = mean(values);
  // First order in W/n: W about 30 of n = 380 samples, 8 %, and three standard errors of 2.5 %.
  CHECK(std::abs(found.value / exact - 1) < 0.08 + 3 * found.error / exact);
  const double scatter = found.error * std::sqrt(static_cast<double>(values.size()));
  CHECK(mean(errors).value / scatter > 0.75);
  CHECK(mean(errors).value / scatter < 1.35);
}

TEST_CASE("runs of different lengths count by their samples, and all must be long enough") {
  const auto one = autoregressive(0.5, 2000, 1), two = autoregressive(0.5, 500, 2);
  const std::vector<std::span<const double>> runs{one, two};
  const auto tau = autocorrelation_time(runs);
  REQUIRE(tau);
  CHECK(std::abs(tau->value - 1.5) < 4 * tau->error);
  CHECK(tau->error ==
        doctest::Approx(autocorrelation_time(one)->error * std::sqrt(0.8)).epsilon(0.3));
  const std::vector<std::span<const double>> with_short{one, std::span(two).first(9)};
  CHECK(!autocorrelation_time(with_short));
  CHECK(!autocorrelation_time(std::vector<std::span<const double>>{}));
}

TEST_CASE("there is no autocorrelation time of few or constant values, nor of a slow drift") {
  CHECK(!autocorrelation_time(autoregressive(0.5, 9, 1)));
  CHECK(!autocorrelation_time(std::vector<double>(100, 3.0)));
  std::vector<double> ramp;
  for (int i = 0; i < 100; ++i) ramp.push_back(i);
  CHECK(!autocorrelation_time(ramp));
}
