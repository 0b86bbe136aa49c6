// SPDX-License-Identifier: MIT
#include "polhode/measure/fluctuation.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "polhode/base/units.hpp"
#include "polhode/io/molecule_file.hpp"

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
    e.lennard_jones = v;
    e.translation = total - v;
    samples.push_back(e);
  }
  return samples;
}

}  // namespace

// Sines over whole periods: rms = amplitude/√2 for both, so R = 0.8/80.
TEST_CASE("R is the ratio of the rms fluctuations") {
  const auto samples = oscillating(0, 0, 1);
  CHECK(fluctuation_ratio(samples) == doctest::Approx(0.01).epsilon(1e-12));
  // Blocks hold whole periods, so leaving one out changes R by rounding only.
  CHECK(fluctuation_ratio_with_error(samples).error < 1e-8);
}

// White noise in both energies: an rms from n samples is known to 1/√(2n), so R to 1/√n. Twenty
// blocks know an error to 1/√(2 × 19) = 16 %; four times that.
TEST_CASE("the error of R of one trajectory") {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  std::vector<Energies> samples(4000);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i].time = 0.004 * static_cast<double>(i);
    samples[i].coulomb = 80 * normal(random);
    samples[i].translation = 0.4 * normal(random) - samples[i].coulomb;
  }
  const Estimate R = fluctuation_ratio_with_error(samples);
  CHECK(R.error == doctest::Approx(R.value / std::sqrt(4000.0)).epsilon(0.64));
  CHECK(std::abs(R.value - 0.005) < 4 * R.error);
}

// White noise of deviation s on 4000 samples over 16 ps: the slope's error is s √12/(√n T).
TEST_CASE("drift of one trajectory: value, error and significance") {
  const double s = 0.5, expected_error = s * std::sqrt(12) / (std::sqrt(4000.0) * 16);
  const Drift still = drift(oscillating(0, s, 2));
  CHECK(std::abs(still.rate.value) < 4 * expected_error);
  // 18 degrees of freedom: the error itself is known to 1/√36, so within 4 of these.
  CHECK(still.rate.error == doctest::Approx(expected_error).epsilon(4.0 / 6));
  CHECK(still.chance > 1e-4);
  const Drift moving = drift(oscillating(20 * expected_error, s, 3));
  CHECK(moving.rate.value == doctest::Approx(20 * expected_error).epsilon(0.2));
  CHECK(moving.chance < significance);
}

TEST_CASE("drift of a series is the mean of its slopes against their scatter") {
  const std::vector<double> rates = {1.0, 1.2, 0.8, 1.1, 0.9};
  const Drift d = drift_of_series(rates);
  CHECK(d.rate.value == doctest::Approx(1.0));
  CHECK(d.rate.error == doctest::Approx(std::sqrt(0.1 / 4 / 5)));
  CHECK(d.chance < significance);
  CHECK(drift_of_series(std::vector<double>{1.0, -1.1, 0.9, -1.0, 0.2}).chance > 0.5);
}

// By hand: 9 bodies move in 27 ways less the 3 of the total momentum; atoms do not turn, linear
// bodies about two axes (J1 = 0), water about three. A single body is its own centre of mass.
TEST_CASE("freedoms of a mixture") {
  const Topology mixture{
      {{read_molecule("argon"), 3}, {read_molecule("n2"), 2}, {read_molecule("tip4p"), 4}}};
  const Freedoms n = freedoms(mixture);
  CHECK(n.translation == 24);
  CHECK(n.rotation[0] == 4);
  CHECK(n.rotation[1] == 6);
  CHECK(n.rotation[2] == 6);
  CHECK(n.all() == 40);
  CHECK(freedoms({{{read_molecule("argon"), 1}}}).all() == 0);
  CHECK(freedoms({{{read_molecule("n2"), 1}}}).all() == 2);
  CHECK(freedoms({{{read_molecule("argon"), 2}}}).all() == 3);
}

TEST_CASE("temperature counts freedoms") {
  CHECK(temperature(0.5 * units::boltzmann * 300 * 6, 6) == doctest::Approx(300));
  CHECK(temperature(1, 0) == 0);
}
