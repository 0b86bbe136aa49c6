// SPDX-License-Identifier: MIT
#include "measure/zero_frequency.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include "polhode/math/random.hpp"
#include "polhode/measure/correlated_series.hpp"

using namespace polhode;

namespace {

/// The spectrum of exponential autocorrelation functions a exp(−t/τ).
struct Exponentials {
  std::vector<std::pair<double, double>> terms;  ///< a and τ

  double at(double frequency) const {
    double sum = 0;
    for (const auto& [a, time] : terms)
      sum += 2 * a * time / (1 + std::pow(2 * std::numbers::pi * frequency * time, 2));
    return sum;
  }
};

std::vector<double> on_bins(const ModeBins& bins, const std::function<double(double)>& f) {
  std::vector<double> values;
  for (std::size_t b = 0; b < bins.size(); ++b) values.push_back(f(bins.middle(b)));
  return values;
}

/// A draw of the mean periodogram of independent series: in each mode a mean of exponentially
/// distributed values.
std::vector<double> draw(const ModeBins& bins, std::size_t series, double length,
                         const Exponentials& exact, Random& random) {
  std::vector<double> means;
  for (std::size_t b = 0; b < bins.size(); ++b) {
    double sum = 0;
    for (std::size_t k = bins.first(b); k < bins.first(b) + bins.count(b); ++k) {
      const double mean = exact.at(static_cast<double>(k) / length);
      for (std::size_t j = 0; j < series; ++j) {
        const double x = random.normal(), y = random.normal();
        sum += mean * (x * x + y * y) / 2;
      }
    }
    means.push_back(sum / static_cast<double>(series * bins.count(b)));
  }
  return means;
}

}  // namespace

TEST_CASE("bins of modes follow each other without gaps, and are a seventh wide at most") {
  const ModeBins bins(2000);
  CHECK(bins.first(0) == 1);
  for (std::size_t b = 0; b + 1 < bins.size(); ++b)
    CHECK(bins.first(b) + bins.count(b) == bins.first(b + 1));
  for (std::size_t b = 0; b < bins.size(); ++b)
    CHECK(static_cast<double>(bins.count(b) - 1) <= 0.15 * static_cast<double>(bins.first(b)));
  const std::size_t last = bins.size() - 1;
  CHECK(bins.first(last) <= 2000);
  CHECK(bins.first(last) + bins.count(last) > 2000);
}

TEST_CASE("the expected periodogram of an exponential process has no bias of order 1/T") {
  // The process x' = d x + √(1 − d²) g is a linear function of independent numbers g. Its expected
  // periodogram is the sum of the periodograms of the responses to each of them.
  constexpr std::size_t samples = 800;
  constexpr double time = 5;
  const double d = std::exp(-1 / time);
  const ModeBins bins(6);
  std::vector<double> expected(bins.size());
  for (std::size_t m = 0; m < samples; ++m) {
    std::vector<double> response(samples);
    double last = m == 0 ? 1 : std::sqrt(1 - d * d);
    for (std::size_t j = m; j < samples; ++j, last *= d) response[j] = last;
    const std::vector<double> one = binned_periodogram(response, 1, bins);
    for (std::size_t b = 0; b < expected.size(); ++b) expected[b] += one[b];
  }
  for (std::size_t b = 0; b < bins.size(); ++b) {
    REQUIRE(bins.count(b) == 1);
    const double cosine = std::cos(2 * std::numbers::pi * bins.middle(b) / samples);
    const double exact = (1 - d * d) / (1 - 2 * d * cosine + d * d);
    // The taper leaves −26 (τ/T)² = −0.1 % at the lowest modes; without it, −τ/T is −0.6 %.
    CHECK(expected[b] == doctest::Approx(exact).epsilon(0.0015));
  }
}

TEST_CASE("a polynomial of degree 2 is extrapolated exactly") {
  const ModeBins bins(2000);
  const auto f = [](double mode) {
    const double x = std::pow(mode / 2000, 2);
    return 3 * std::exp(-2 * x + 0.5 * x * x);
  };
  // With 1e12 series, a straight line has no probability.
  const std::vector<double> exact = on_bins(bins, f);
  const ZeroFrequency found(exact, 1e12, bins);
  CHECK(found.value(exact) == doctest::Approx(3).epsilon(1e-9));
  CHECK(found.max_mode() > 1000);  // the fits do not stop before they must
  std::vector<double> broken = exact;
  broken[3] = 0;
  CHECK(std::isnan(found.value(broken)));
  CHECK(std::isnan(ZeroFrequency(broken, 100, bins).value(exact)));
}

TEST_CASE("the interval of the spectrum at zero frequency contains its value as often as stated") {
  // As of a liquid: a fast decay, a slow one, and a tail that is long in the second case. 48
  // segments of five components.
  double length = 0;
  Exponentials exact;
  SUBCASE("a weak tail") { length = 150, exact.terms = {{0.8, 0.06}, {0.2, 0.4}, {0.02, 1.5}}; }
  SUBCASE("a strong tail") { length = 72, exact.terms = {{0.7, 0.03}, {0.2, 0.6}, {0.1, 1.5}}; }
  constexpr std::size_t components = 5, segments = 48, seeds = 200;
  const ModeBins bins(1000);
  int within_68 = 0, within_95 = 0;
  double sum = 0, squares = 0, stated = 0;
  for (std::size_t seed = 0; seed < seeds; ++seed) {
    Random random(5, seed);
    std::vector<BlockMeans::Block> blocks;
    for (std::size_t k = 0; k < segments; ++k)
      blocks.push_back({1, draw(bins, components, length, exact, random)});
    const BlockMeans run(blocks);
    const ZeroFrequency zero(run.mean(), components * segments, bins);
    const SeriesEstimate found = pooled_estimate(std::vector<BlockMeans>{run},
                                                 [&](auto means) { return zero.value(means); });
    REQUIRE(found.known == Known::yes);
    const double deviation = found.value / exact.at(0) - 1, error = found.error / exact.at(0);
    if (std::abs(deviation) < interval_factor(found, 0.6827) * error) ++within_68;
    if (std::abs(deviation) < interval_factor(found, 0.95) * error) ++within_95;
    sum += deviation;
    squares += deviation * deviation;
    stated += error * error;
  }
  // Binomial numbers of 200: 136.5 ± 6.6 and 190 ± 3.1, within three standard deviations.
  CHECK(within_68 >= 117);
  CHECK(within_68 <= 156);
  CHECK(within_95 >= 181);
  // The bias is below a half of the error of one measurement, whose error of the mean is 0.07.
  const double scatter = std::sqrt(squares / seeds);
  CHECK(std::abs(sum / seeds) < 0.5 * scatter);
  // Stated errors over the scatter; both have relative uncertainties of 1/√400 and less.
  CHECK(std::sqrt(stated / seeds) > 0.85 * scatter);
  CHECK(std::sqrt(stated / seeds) < 1.3 * scatter);
  MESSAGE("bias ", sum / seeds, ", scatter ", scatter, ", stated ", std::sqrt(stated / seeds),
          ", within 68 %: ", within_68, ", within 95 %: ", within_95);
}
