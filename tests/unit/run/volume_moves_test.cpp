// SPDX-License-Identifier: MIT
// The size of barostat moves of a replica.
#include "run/properties/chain.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "io/settings/ensemble_names.hpp"
#include "polhode/base/units.hpp"
#include "polhode/math/random.hpp"

using namespace polhode;

namespace {

constexpr double kelvins = 160, V = 3;
constexpr StatePoint at{kelvins, 30};

/// A segment of 100 independent volumes of a system with this compressibility.
AveragesSegment segment(double compressibility, std::uint64_t number) {
  constexpr std::size_t samples = 100;
  AveragesSegment s{.sums = {samples, std::vector<double>(averages_count)}, .response = {}};
  Random random(4, number);
  const double deviation =
      std::sqrt(compressibility * units::boltzmann * kelvins * V);  // of the volume
  for (std::size_t k = 0; k < samples; ++k) {
    const double volume_now = V + deviation * random.normal();
    s.sums.sum[volume] += volume_now;
    s.sums.sum[volume_squared] += volume_now * volume_now;
  }
  return s;
}

}  // namespace

TEST_CASE("barostat moves follow the volume fluctuations of earlier segments") {
  const double first = default_compressibility(), exact = 7 * first;
  // Segments of 37.5 ps, 12 relaxation times of the volume.
  Replica replica{.step = 0.03, .compressibility = first};
  CHECK(compressibility_of_moves(replica, at) == first);
  std::vector<double> sizes;
  for (std::uint64_t k = 0; k < 16; ++k) {
    replica.averages.push_back(segment(k == 0 ? 100 * exact : exact, k));  // it condenses first
    sizes.push_back(compressibility_of_moves(replica, at));
  }
  CHECK(sizes[0] == first);  // after one segment
  // The variance of 100 (n) independent volumes has a relative error of √(2/100 n); 4 deviations.
  CHECK(sizes[1] / exact == doctest::Approx(1).epsilon(4 * std::sqrt(2 / 100.0)));
  CHECK(sizes[15] / exact == doctest::Approx(1).epsilon(4 * std::sqrt(2 / 800.0)));
  // The value changes when the number of segments has doubled, so few segments have transients.
  for (const std::size_t k : {2u, 4u, 5u, 6u, 8u, 14u}) CHECK(sizes[k] == sizes[k - 1]);
  for (const std::size_t k : {3u, 7u, 15u}) CHECK(sizes[k] != sizes[k - 1]);
  // A resumed replica has the same moves: the value depends on the segments alone.
  Replica resumed{.step = 0.03, .compressibility = first, .averages = replica.averages};
  CHECK(compressibility_of_moves(resumed, at) == sizes[15]);
  // Segments of 5 ps: four of them last eight relaxation times of 2 ps.
  for (const std::size_t k : {4u, 7u, 8u, 15u}) {
    Replica slow{.step = 0.004, .compressibility = first};
    slow.averages.assign(replica.averages.begin(), replica.averages.begin() + static_cast<long>(k));
    CHECK((compressibility_of_moves(slow, at) == first) == (k < 8));
  }
  // Volumes that do not fluctuate do not stop the barostat, and a drift does not make it overshoot.
  for (AveragesSegment& s : replica.averages) s = segment(0, 1);
  CHECK(compressibility_of_moves(replica, at) / first == doctest::Approx(1.0 / 16));
  for (AveragesSegment& s : replica.averages) s = segment(1000 * first, 1);
  CHECK(compressibility_of_moves(replica, at) / first == doctest::Approx(16));
}
