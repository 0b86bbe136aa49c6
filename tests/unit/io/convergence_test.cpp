// SPDX-License-Identifier: MIT
// The test for convergence on motion with a known relaxation time: how often it fires when it
// should, and when it should not.
#include "measure/convergence.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "measure/displacement.hpp"
#include "measure/velocity_correlation.hpp"
#include "polhode/io/topology/molecule_file.hpp"
#include "polhode/math/random.hpp"

using namespace polhode;

namespace {

constexpr int series_with_start = 200;

/// How many of many series of a kind are called converged.
double share_converged(const std::function<Convergence(std::uint64_t seed)>& one) {
  int converged = 0;
  for (int seed = 0; seed < series_with_start; ++seed)
    converged += one(static_cast<std::uint64_t>(seed)).converged() ? 1 : 0;
  return static_cast<double>(converged) / series_with_start;
}

double mean_square(std::span<const double> mean) { return mean[3]; }

/// A vector whose components are Ornstein-Uhlenbeck processes of relaxation time `tau`, as the
/// dipole of a liquid.
Convergence of_vector(std::uint64_t seed, double length, double tau) {
  Random random(seed);
  TimeBlocks blocks;
  const double kept = std::exp(-1 / tau);
  std::array<double, 3> M{random.normal(), random.normal(), random.normal()};
  for (double t = 0; t < length; ++t) {
    for (double& x : M) x = kept * x + std::sqrt(1 - kept * kept) * random.normal();
    blocks.add(std::array{M[0], M[1], M[2], M[0] * M[0] + M[1] * M[1] + M[2] * M[2]});
  }
  const BlockMeans means = blocks.means();
  const SeriesEstimate square = series_estimate(means, mean_square);
  const bool open = square.known != Known::yes || still_moving(means, square, mean_square);
  return convergence(length, relaxation_share(means, 0, 3) * length, relaxations_of_dipole,
                     open ? Obstacle::still_moving : Obstacle::none);
}

/// Walkers whose velocities are Ornstein-Uhlenbeck processes, so that the slope of their
/// mean-square displacement is constant after a few relaxation times only.
Convergence of_walkers(std::uint64_t seed, int frames, double tau, int lags) {
  const std::size_t bodies = 10;
  const Topology topology{{{read_molecule("argon"), bodies}}};
  State state(bodies, Box{{1e4, 1e4, 1e4}});
  Random random(seed);
  const auto normal3 = [&] {
    const double x = random.normal(), y = random.normal(), z = random.normal();
    return Vec3<double>{x, y, z};
  };
  std::vector<Vec3<double>> v(bodies);
  for (Vec3<double>& each : v) each = normal3();
  const double kept = std::exp(-1 / tau);
  Displacement displacement(topology, static_cast<std::size_t>(lags) + 1);
  for (int t = 0; t < frames; ++t) {
    displacement.add(state);
    for (std::size_t i = 0; i < bodies; ++i) {
      v[i] = kept * v[i] + std::sqrt(1 - kept * kept) * normal3();
      state.q.add(i, v[i]);
    }
  }
  const auto max_lag = static_cast<double>(lags);
  return diffusion_convergence(displacement.mean_square(0), 1, {max_lag / 5, max_lag});
}

/// Velocities of ten such walkers.
Convergence of_velocities(std::uint64_t seed, int frames, double tau, int lags) {
  const std::size_t bodies = 10;
  std::vector<double> v(3 * bodies);
  Random random(seed);
  for (double& x : v) x = random.normal();
  const double kept = std::exp(-1 / tau);
  TimeCorrelation correlation(bodies, static_cast<std::size_t>(lags) + 1, {Product::dot});
  for (int t = 0; t < frames; ++t) {
    correlation.add([&](std::size_t i) {
      return Vec3<double>{v[3 * i], v[3 * i + 1], v[3 * i + 2]};
    });
    for (double& x : v) x = kept * x + std::sqrt(1 - kept * kept) * random.normal();
  }
  return integral_convergence(correlation.means(0), 1);
}

}  // namespace

// The bounds allow for three standard deviations of a binomial share of 200: at most 0.03 at 2 %.
TEST_CASE("a vector has converged after 100 relaxation times, and not after 10") {
  constexpr double tau = 20;
  CHECK(share_converged([](auto seed) { return of_vector(seed, tau / 2, tau); }) == 0);
  CHECK(share_converged([](auto seed) { return of_vector(seed, 2 * tau, tau); }) <= 0.01);
  CHECK(share_converged([](auto seed) { return of_vector(seed, 10 * tau, tau); }) < 0.06);
  CHECK(share_converged([](auto seed) { return of_vector(seed, 100 * tau, tau); }) > 0.93);
  CHECK(share_converged([](auto seed) { return of_vector(seed, 400 * tau, tau); }) > 0.95);
}

TEST_CASE("the relaxation time is right for long series, and too short for short ones") {
  constexpr double tau = 20;
  const auto mean = [](double length) {
    double sum = 0;
    for (std::uint64_t seed = 0; seed < series_with_start; ++seed)
      sum += of_vector(seed, length, tau).relaxation / series_with_start;
    return sum;
  };
  // |M̄|² of the quarters, the shortest stretches, misses τ/25τ of it; its scatter over 200 series
  // is about 0.5/√200.
  CHECK(mean(100 * tau) == doctest::Approx(tau).epsilon(0.13));
  CHECK(mean(2 * tau) < 0.5 * tau);
}

TEST_CASE("D has converged if the slope is constant, and not while walkers keep their velocities") {
  CHECK(share_converged([](auto seed) { return of_walkers(seed, 1500, 0.5, 20); }) > 0.93);
  CHECK(share_converged([](auto seed) { return of_walkers(seed, 100, 0.5, 20); }) == 0);
  CHECK(share_converged([](auto seed) { return of_walkers(seed, 1500, 20, 20); }) < 0.05);
}

TEST_CASE("D is fitted to the lags within the window, up to the rounding of their times") {
  // The slope is 6 at all lags up to 4, and 600 beyond.
  std::vector<BlockMeans::Block> blocks(64, {1000, {}});
  for (BlockMeans::Block& block : blocks)
    for (int lag = 0; lag <= 8; ++lag)
      block.sum.push_back(1000 * (lag <= 4 ? 6.0 * lag : 600.0 * lag));
  const auto D = [&](double from, double to) {
    return diffusion(BlockMeans(blocks), 1, {from, to}).value;
  };
  CHECK(D(0, 4) == doctest::Approx(1));
  CHECK(D(1, 4.4) == doctest::Approx(1));
  CHECK(D(1, 4.6) == doctest::Approx(1));
  CHECK(D(4.6, 8) == doctest::Approx(100));
  CHECK(D(5.001, 8) == doctest::Approx(100));
  CHECK(D(5.001, 6.999) == doctest::Approx(100));
  CHECK(std::isnan(D(5.1, 6.9)));
}

TEST_CASE("a result with an obstacle needs a longer run than there was") {
  CHECK(convergence(100, 2, 30).converged());
  CHECK(!convergence(100, 2, 30, Obstacle::still_moving).converged());
  CHECK(convergence(100, 2, 30, Obstacle::still_moving).needed == 200);
  CHECK(convergence(100, 5, 30).obstacle == Obstacle::length);
  CHECK(convergence(100, 5, 30).needed == 150);
}

TEST_CASE("D needs eight windows of lags, however short the run is") {
  for (const int frames : {100, 150}) {
    const Convergence c = of_walkers(1, frames, 0.5, 20);
    CHECK(c.obstacle == Obstacle::length);
    CHECK(c.needed == windows_of_lags * 20);
  }
}

// C = exp(−t/τ). At an interval of 1.5 τ the trapezoidal rule gives 0.75 coth 0.75 = 1.18 of the
// integral, far beyond the error of a few percent; at 0.1 τ it gives 1.0008.
TEST_CASE("an integral over velocities has not converged if they are too far apart") {
  const auto obstacles = [](double tau, Obstacle which) {
    int found = 0;
    for (std::uint64_t seed = 0; seed < 50; ++seed)
      found += of_velocities(seed, 3000, tau, static_cast<int>(5 * tau) + 1).obstacle == which;
    return found;
  };
  CHECK(obstacles(10, Obstacle::interval) == 0);
  CHECK(obstacles(10, Obstacle::none) >= 45);
  CHECK(obstacles(2.0 / 3, Obstacle::interval) == 50);
}
