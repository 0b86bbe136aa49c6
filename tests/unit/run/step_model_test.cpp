// SPDX-License-Identifier: MIT
#include "polhode/run/adviser/step_model.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "math/prediction.hpp"

using namespace polhode;

namespace {

// R = a hᵖ exp(c h²) with h in fs, as for HOA2 on water near its stability limit.
constexpr int order = 2;
constexpr double a = 2e-4, c = 0.01;

double log_law(double fs) { return std::log(a) + order * std::log(fs) + c * fs * fs; }

// Runs from `starts` initial configurations, each of which has its own deviation from the power
// law, plus one of each run.
std::vector<StepPoint> runs(std::mt19937_64& random, std::size_t starts, double by_start,
                            double by_run) {
  std::normal_distribution<double> normal;
  std::vector<double> own(starts);
  for (double& u : own) u = by_start * normal(random);
  std::vector<StepPoint> points;
  for (const double fs : {4.0, 4.5, 5.0}) {
    points.push_back({fs / 1000, {}});
    for (const double u : own)
      points.back().ratios.push_back(std::exp(log_law(fs) + u + by_run * normal(random)));
  }
  return points;
}

}  // namespace

TEST_CASE("a power law without noise is recovered") {
  std::mt19937_64 random(1);
  const StepModel model(order, runs(random, 4, 0, 0));
  for (const double fs : {3.5, 4.2, 5.5}) {
    CHECK(model.log_ratio(fs / 1000).value == doctest::Approx(log_law(fs)).epsilon(1e-9));
    CHECK(model.exponent(fs / 1000) == doctest::Approx(2 + 2 * c * fs * fs).epsilon(1e-8));
  }
  // Without scatter the bound equals R: the step at R(4.4 fs) is 4.4 fs, within the 0.2 % of the
  // search.
  const double step = model.max_step(std::exp(log_law(4.4)), 0.975, 0.005);
  CHECK(step <= 0.0044 * (1 + 1e-9));
  CHECK(step > 0.0044 * 0.997);
  // One step: the power law of the order through that point.
  const StepModel one(4, {{0.004, {0.01, 0.01}}});
  CHECK(std::exp(one.log_ratio(0.005).value) == doctest::Approx(0.01 * std::pow(1.25, 4)));
}

// Scatter between initial configurations only: s and the error of the line are those of six
// independent values, so Student's t with 5 degrees of freedom is exact: 97.5 % of new runs are
// below the bound, and the true law is in 95 % of the intervals log R ± t error. 4 binomial
// standard deviations of 3000 are 34 and 48.
TEST_CASE("intervals contain the true value at the stated rate") {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  const double t = t_quantile(0.975, 5);
  int fresh = 0, law = 0;
  for (int k = 0; k < 3000; ++k) {
    const StepModel model(order, runs(random, 6, 0.05, 0));
    if (log_law(4.4) + 0.05 * normal(random) < std::log(model.bound(0.0044, 0.975))) ++fresh;
    const Estimate log = model.log_ratio(0.0044);
    if (std::abs(log.value - log_law(4.4)) < t * log.error) ++law;
  }
  CHECK(std::abs(fresh - 2925) < 34);
  CHECK(std::abs(law - 2850) < 48);
}

// Runs independent of their initial configurations: s then has 15 degrees of freedom instead of 5,
// so the bound is conservative. Between 97.5 % and P(t₁₅ < t(0.975; 5) = 2.571) = 98.9 %, and 4
// deviations (23) more.
TEST_CASE("the bound is conservative if runs scatter independently") {
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal;
  int fresh = 0;
  for (int k = 0; k < 3000; ++k) {
    const StepModel model(order, runs(random, 6, 0, 0.05));
    if (log_law(4.4) + 0.05 * normal(random) < std::log(model.bound(0.0044, 0.975))) ++fresh;
  }
  CHECK(fresh > 2925 - 34);
  CHECK(fresh < 2968 + 23);
}
