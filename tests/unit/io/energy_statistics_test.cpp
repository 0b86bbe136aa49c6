// SPDX-License-Identifier: MIT
#include "polhode/measure/energy_statistics.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "polhode/base/units.hpp"
#include "polhode/io/topology/molecule_file.hpp"

using namespace polhode;

namespace {

// Potential and total energy as sums of a few oscillations of known amplitude, and a drift.
std::vector<Energies> oscillating(double drift, double noise, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::vector<Energies> samples;
  for (int i = 0; i < 4000; ++i) {
    Energies e{};
    e.time = 0.004 * i;
    const double v = 80 * std::sin(2 * units::pi * e.time / 0.4);
    const double total =
        0.8 * std::sin(2 * units::pi * e.time / 0.04) + drift * e.time + noise * normal(random);
    e.van_der_waals = v;
    e.translation = total - v;
    samples.push_back(e);
  }
  return samples;
}

}  // namespace

// Sines over whole periods: rms = amplitude/√2 for both, so R = 0.8/80.
TEST_CASE("R is the ratio of the rms fluctuations") {
  const auto samples = oscillating(0, 0, 1);
  CHECK(EnergyStatistics(samples).ratio() == doctest::Approx(0.01).epsilon(1e-12));
}

// White noise in both energies: an rms from n samples is known to 1/√(2n), so R to 1/√n. Eight
// modes or fewer determine an error to 1/√8 at best; five times that is allowed either way.
TEST_CASE("the error of R of one trajectory") {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  std::vector<Energies> samples(4000);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i].time = 0.004 * static_cast<double>(i);
    samples[i].coulomb = 80 * normal(random);
    samples[i].translation = 0.4 * normal(random) - samples[i].coulomb;
  }
  const SeriesEstimate R = EnergyStatistics(samples).ratio_with_error();
  REQUIRE(R.known == Known::yes);
  CHECK(R.error > R.value / std::sqrt(4000.0) / 2.8);
  CHECK(R.error < R.value / std::sqrt(4000.0) * 2.8);
  CHECK(std::abs(R.value - 0.005) < 4 * R.value / std::sqrt(4000.0));
}

// White noise of deviation s on 4000 samples over 16 ps: the slope's error is s √12/(√n T).
TEST_CASE("drift of one trajectory: value, error and significance") {
  const double s = 0.5, expected_error = s * std::sqrt(12) / (std::sqrt(4000.0) * 16);
  const Drift still = EnergyStatistics(oscillating(0, s, 2)).drift();
  CHECK(std::abs(still.rate.value) < 4 * expected_error);
  CHECK(still.rate.error > expected_error / 2.8);
  CHECK(still.rate.error < expected_error * 2.8);
  CHECK(!still.significant());
  const Drift moving = EnergyStatistics(oscillating(20 * expected_error, s, 3)).drift();
  CHECK(moving.rate.value == doctest::Approx(20 * expected_error).epsilon(0.2));
  CHECK(moving.significant());
}

// The sums are of differences from the first sample: means and fluctuations are those of the
// samples to the last digits, however long the series.
TEST_CASE("accumulated energy statistics equal those of all samples") {
  const auto samples = oscillating(0.3, 0.5, 4);
  const EnergyStatistics statistics(samples);
  double total = 0, potential = 0, pairs = 0;
  for (const Energies& e : samples) total += e.total() / 4000, potential += e.potential() / 4000;
  for (const Energies& e : samples) pairs += std::pow(e.total() - total, 2) / 4000;
  CHECK(statistics.samples == 4000);
  CHECK(statistics.blocks.blocks.size() <= 40);
  CHECK(statistics.total() == doctest::Approx(total).epsilon(1e-12));
  CHECK(statistics.potential() == doctest::Approx(potential).epsilon(1e-12));
  CHECK(statistics.total_fluctuation() == doctest::Approx(std::sqrt(pairs)).epsilon(1e-12));
}

// Stretches of 1000 samples hold 10 periods of V: R of each, and their mean, is that of the whole;
// an incomplete stretch is ignored.
TEST_CASE("R over stretches") {
  const auto samples = oscillating(0, 0, 1);
  StretchStatistics stretches;
  for (std::size_t k = 0; k < 3999; ++k) stretches.add(samples[k], samples[0], 1000);
  REQUIRE(stretches.ratio());
  CHECK(stretches.stretches == 3);
  CHECK(stretches.ratio()->value == doctest::Approx(0.01).epsilon(1e-9));
  CHECK(stretches.ratio()->error < 1e-9);
  StretchStatistics one;
  for (std::size_t k = 0; k < 1999; ++k) one.add(samples[k], samples[0], 1000);
  CHECK(!one.ratio());
}

TEST_CASE("the drift of several runs is the mean of their slopes with its standard error") {
  const std::vector<double> rates = {1.0, 1.2, 0.8, 1.1, 0.9};
  const Drift d = drift_of_series(rates);
  CHECK(d.rate.value == doctest::Approx(1.0));
  CHECK(d.rate.error == doctest::Approx(std::sqrt(0.1 / 4 / 5)));
  CHECK(d.p_value < significance);
  CHECK(drift_of_series(std::vector<double>{1.0, -1.1, 0.9, -1.0, 0.2}).p_value > 0.5);
}

// By hand: 9 bodies have 27 translations minus the 3 of the total momentum; atoms do not rotate,
// linear bodies about two axes (J1 = 0), water about three. A single body is its own centre of
// mass.
TEST_CASE("degrees of freedom of a mixture") {
  const Topology mixture{
      {{read_molecule("argon"), 3}, {read_molecule("n2"), 2}, {read_molecule("tip4p"), 4}}};
  const DegreesOfFreedom n = degrees_of_freedom(mixture);
  CHECK(n.translation == 24);
  CHECK(n.rotation[0] == 4);
  CHECK(n.rotation[1] == 6);
  CHECK(n.rotation[2] == 6);
  CHECK(n.all() == 40);
  CHECK(degrees_of_freedom({{{read_molecule("argon"), 1}}}).all() == 0);
  CHECK(degrees_of_freedom({{{read_molecule("n2"), 1}}}).all() == 2);
  CHECK(degrees_of_freedom({{{read_molecule("argon"), 2}}}).all() == 3);
}

TEST_CASE("temperature counts degrees of freedom") {
  CHECK(temperature(0.5 * units::boltzmann * 300 * 6, 6) == doctest::Approx(300));
  CHECK(temperature(1, 0) == 0);
}
