// SPDX-License-Identifier: MIT
#include "measure/time_correlation.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "polhode/math/random.hpp"

using namespace polhode;

namespace {

using VectorSeries = std::vector<std::vector<Vec3<double>>>;  // [frame][body]

// Steps of a walk, far from the origin.
VectorSeries walk(std::size_t frames, std::size_t bodies) {
  Random random(11);
  VectorSeries series(frames, std::vector<Vec3<double>>(bodies, {3, -2, 5}));
  for (std::size_t t = 1; t < frames; ++t)
    for (std::size_t i = 0; i < bodies; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        series[t][i][k] = series[t - 1][i][k] + 0.1 * random.normal();
  return series;
}

double product(Product p, const Vec3<double>& a, const Vec3<double>& b) {
  switch (p) {
    case Product::dot:
      return dot(a, b);
    case Product::dot_squared:
      return dot(a, b) * dot(a, b);
    case Product::x:
      return a.x * b.x;
    case Product::y:
      return a.y * b.y;
    case Product::z:
      return a.z * b.z;
    case Product::displacement_x:
      return std::pow(a.x - b.x, 2);
    case Product::displacement_y:
      return std::pow(a.y - b.y, 2);
    case Product::displacement_z:
      return std::pow(a.z - b.z, 2);
  }
  return 0;
}

// The mean over all origins and bodies, directly from its definition.
double direct(Product p, const VectorSeries& series, std::size_t lag) {
  double sum = 0, count = 0;
  for (std::size_t t = lag; t < series.size(); ++t)
    for (std::size_t i = 0; i < series[t].size(); ++i, ++count)
      sum += product(p, series[t][i], series[t - lag][i]);
  return sum / count;
}

const std::vector<Product> all = {Product::dot,
                                  Product::dot_squared,
                                  Product::x,
                                  Product::y,
                                  Product::z,
                                  Product::displacement_x,
                                  Product::displacement_y,
                                  Product::displacement_z};

}  // namespace

// Transforms agree with the definition up to rounding of sums of numbers up to 60² (squared scalar
// products) over about a hundred terms. Windows filled by the frames exactly, in part, or not at
// all; more and fewer bodies than groups.
TEST_CASE("correlations over windows are the direct sums over all origins") {
  for (const std::size_t frames : {2U, 7U, 24U, 31U, 96U})
    for (const std::size_t lags : {1U, 8U, 20U})
      for (const std::size_t bodies : {1U, 3U, 37U}) {
        const VectorSeries series = walk(frames, bodies);
        TimeCorrelation correlation(bodies, lags, all);
        for (const auto& frame : series) correlation.add([&](std::size_t i) { return frame[i]; });
        for (std::size_t p = 0; p < all.size(); ++p) {
          const std::vector<double> means = correlation.means(p).mean();
          REQUIRE(means.size() == std::min(lags, frames / 2 + 1));
          for (std::size_t lag = 0; lag < means.size(); ++lag) {
            CAPTURE(frames);
            CAPTURE(lags);
            CAPTURE(bodies);
            CAPTURE(lag);
            CAPTURE(p);
            const double exact = direct(all[p], series, lag);
            CHECK(std::abs(means[lag] - exact) < 1e-12 * (1 + std::abs(exact)));
          }
        }
      }
}

TEST_CASE(
    "correlations have the same bits for any number of threads, and may be read during the "
    "analysis") {
  const VectorSeries series = walk(50, 70);
  Workers workers(4);
  TimeCorrelation one(70, 12, {Product::displacement_x}), many(70, 12, {Product::displacement_x});
  for (std::size_t t = 0; t < series.size(); ++t) {
    one.add([&](std::size_t i) { return series[t][i]; });
    many.add([&](std::size_t i) { return series[t][i]; }, workers);
    if (t == 29) {
      const VectorSeries first(series.begin(), series.begin() + 30);
      TimeCorrelation early(70, 12, {Product::displacement_x});
      for (const auto& frame : first) early.add([&](std::size_t i) { return frame[i]; });
      early.means(0);
      for (std::size_t later = 30; later < 50; ++later)
        early.add([&](std::size_t i) { return series[later][i]; });
      for (std::size_t lag = 0; lag < 12; ++lag)
        CHECK(early.means(0).mean()[lag] ==
              doctest::Approx(direct(Product::displacement_x, series, lag)).epsilon(1e-12));
    }
  }
  const auto a = one.means(0).blocks(), b = many.means(0, workers).blocks();
  REQUIRE(a.size() == b.size());
  for (std::size_t g = 0; g < a.size(); ++g) CHECK(a[g].sum == b[g].sum);
}
