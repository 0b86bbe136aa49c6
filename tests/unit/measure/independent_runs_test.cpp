// SPDX-License-Identifier: MIT
// Errors from several independent runs together, calibrated over many sets of runs.
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "polhode/math/random.hpp"
#include "polhode/measure/correlated_series.hpp"
#include "polhode/measure/step_response.hpp"

using namespace polhode;

namespace {

/// Runs of AR(1) series, x and x² in blocks of ten samples.
std::vector<BlockMeans> runs_of(double rho, const std::vector<std::size_t>& lengths,
                                Random& random) {
  std::vector<BlockMeans> list;
  for (const std::size_t blocks : lengths) {
    double x = random.normal();
    std::vector<BlockMeans::Block> made;
    for (std::size_t b = 0; b < blocks; ++b) {
      BlockMeans::Block block{10, {0, 0}};
      for (int k = 0; k < 10; ++k) {
        x = rho * x + std::sqrt(1 - rho * rho) * random.normal();
        block.sum[0] += x;
        block.sum[1] += x * x;
      }
      made.push_back(std::move(block));
    }
    list.emplace_back(std::move(made));
  }
  return list;
}

const std::vector<std::size_t> equal = {24, 24, 24, 24};

void check_coverage(const std::vector<std::size_t>& lengths) {
  constexpr int sets = 2000;
  for (const double rho : {0.0, 0.8}) {
    CAPTURE(rho);
    Random random(7);
    int in_68[2] = {0, 0}, in_95[2] = {0, 0}, known = 0;
    for (int set = 0; set < sets; ++set) {
      const auto runs = runs_of(rho, lengths, random);
      const SeriesEstimate estimates[2] = {
          pooled_estimate(runs, [](auto mean) { return mean[0]; }),
          pooled_estimate(runs, [](auto mean) { return mean[1] - mean[0] * mean[0]; })};
      if (estimates[0].known != Known::yes || estimates[1].known != Known::yes) continue;
      ++known;
      for (int k = 0; k < 2; ++k) {
        const double off = std::abs(estimates[k].value - k), error = estimates[k].error;
        in_68[k] += off < interval_factor(estimates[k], 0.68) * error;
        in_95[k] += off < interval_factor(estimates[k], 0.95) * error;
      }
    }
    CHECK(known > 0.99 * sets);
    // Four standard deviations of a binomial number in 2000 are 4.2 % at 68 % and 1.95 % at 95 %;
    // the variance is skewed, and its estimate lower by 1/n of 192 independent samples at rho 0.8.
    CHECK(in_68[0] / double(known) == doctest::Approx(0.68).epsilon(0.042 / 0.68));
    CHECK(in_95[0] / double(known) == doctest::Approx(0.95).epsilon(0.0195 / 0.95));
    CHECK(in_68[1] / double(known) == doctest::Approx(0.68).epsilon(0.06 / 0.68));
    CHECK(in_95[1] / double(known) == doctest::Approx(0.95).epsilon(0.03));
  }
}

}  // namespace

TEST_CASE("intervals of four runs together cover the true mean and variance as stated") {
  check_coverage(equal);
}

TEST_CASE("intervals of runs of unequal lengths cover the true mean and variance as stated") {
  check_coverage({12, 16, 24, 44});  // as many blocks in all, and from the minimum on
}

TEST_CASE("a difference between runs makes the error larger") {
  Random random(3);
  std::vector<BlockMeans> runs = runs_of(0, equal, random);
  const double before = pooled_estimate(runs, [](auto mean) { return mean[0]; }).error;
  std::vector<BlockMeans::Block> moved = runs[0].blocks();
  for (BlockMeans::Block& block : moved) block.sum[0] += 10;  // the mean of this run by 1
  runs[0] = BlockMeans(moved);
  const SeriesEstimate after = pooled_estimate(runs, [](auto mean) { return mean[0]; });
  // The means of the runs are 1 and three times 0, with errors of 1/√240. They scatter by 1/2, so
  // the mean of four has an error of 1/4. Two errors of a mean change the difference of 1 by 15 %.
  CHECK(after.known == Known::yes);
  CHECK(after.modes == 3);
  CHECK(after.error == doctest::Approx(0.25).epsilon(0.15));
  CHECK(after.error > 3 * before);
}

// Each run has a condition of its own, such as a volume, which changes its mean by 20 of its
// errors. This is seen in all sets but one in a thousand, so the intervals are those of four
// numbers.
TEST_CASE("intervals of runs with different conditions cover the true mean as stated") {
  constexpr int sets = 2000;
  Random random(11);
  int in_68 = 0, in_95 = 0;
  for (int set = 0; set < sets; ++set) {
    std::vector<BlockMeans> runs = runs_of(0.8, equal, random);
    for (BlockMeans& run : runs) {
      const double condition = 4 * random.normal();  // 20 errors of 0.2 = √(9/240)
      std::vector<BlockMeans::Block> moved = run.blocks();
      for (BlockMeans::Block& block : moved) block.sum[0] += 10 * condition;
      run = BlockMeans(moved);
    }
    const SeriesEstimate found = pooled_estimate(runs, [](auto mean) { return mean[0]; });
    in_68 += std::abs(found.value) < interval_factor(found, 0.68) * found.error;
    in_95 += std::abs(found.value) < interval_factor(found, 0.95) * found.error;
  }
  // Four standard deviations of a binomial number.
  CHECK(in_68 / double(sets) == doctest::Approx(0.68).epsilon(0.042 / 0.68));
  CHECK(in_95 / double(sets) == doctest::Approx(0.95).epsilon(0.0195 / 0.95));
}

TEST_CASE("sums of a step response relative to another first sample give the same bias") {
  Random random(5);
  StepResponse response;
  for (int k = 0; k < 400; ++k) {
    const double e = random.normal(), K = 50 + random.normal() + 0.3 * e;
    response.add({e, 100 + e + random.normal(), K, 1, 10 + 0.1 * random.normal()},
                 std::vector{K * K, 3 + e});
  }
  std::vector<double> other = response.first;
  for (std::size_t k = 0; k < other.size(); ++k) other[k] += 0.5 + 0.1 * static_cast<double>(k);
  const StepResponse moved = response.relative_to(other);
  const auto f = [](std::span<const double> mean) { return mean[0] + mean[1] * mean[1]; };
  const SeriesEstimate one = response.bias(30, FixedMeans::kinetic_energy, f),
                       same = moved.bias(30, FixedMeans::kinetic_energy, f);
  CHECK(same.value == doctest::Approx(one.value).epsilon(1e-8));
  CHECK(same.error == doctest::Approx(one.error).epsilon(1e-8));
}
