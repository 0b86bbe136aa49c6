// SPDX-License-Identifier: MIT
// The compressibility from the fluctuations of the volume, and that of the moves that follow.
#include "run/prepare/compressibility.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "io/settings/ensemble_names.hpp"
#include "run/simulation/report/warning_rules.hpp"

using namespace polhode;

namespace {

constexpr double V0 = 20, kT = 2.5, length = 50;  // [nm³], [kJ/mol], [ps]

/// A barostat that assumes `assumed` where the volume of a system with `truth` relaxes in 0.5 ps.
BarostatSettings barostat(double assumed, double truth) {
  return {.type = CellRescaling{0.5 * std::min(1.0, assumed / truth)}, .compressibility = assumed};
}

/// Volumes that fluctuate as those of a system with this compressibility, with a correlation time
/// of 0.5 ps, about a mean that relaxes.
/// @param change  of the mean, relative
EnergyStatistics volumes(double compressibility, double change, unsigned seed) {
  constexpr double interval = 0.02;
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0, std::sqrt(kT * compressibility * V0));
  const double memory = std::exp(-interval / 0.5), kick = std::sqrt(1 - memory * memory);
  double off = normal(random);
  EnergyStatistics statistics;
  for (double t = 0; t < length; t += interval, off = memory * off + kick * normal(random)) {
    Energies e;
    e.time = t;
    e.volume = V0 * (1 + change * (1 - std::exp(-t / (length / 3)))) + off;
    statistics.add(e);
  }
  return statistics;
}

}  // namespace

TEST_CASE("the compressibility of fluctuations is known within its error, small or large") {
  for (const double factor : {0.2, 1.0, 8.0}) {
    CAPTURE(factor);
    const double truth = factor * default_compressibility();
    int far = 0;
    for (unsigned seed = 1; seed <= 20; ++seed) {
      const EnergyStatistics v = volumes(truth, 0, seed);
      const BarostatSettings usual = barostat(default_compressibility(), truth);
      const SeriesEstimate found = measured_compressibility(v, usual, length, kT);
      if (found.known != Known::yes) continue;  // a chance drift, at 1 %
      far += std::abs(found.value - truth) > 3 * found.error;
      CHECK(next_compressibility(v, usual, length, kT) == found.value);
      // The same numbers, of a barostat whose relaxation times are seven in this time.
      BarostatSettings slow = usual;
      std::get<CellRescaling>(slow.type).time_constant *=
          length / (7 * volume_relaxation(usual, found.value));
      CHECK(measured_compressibility(v, slow, length, kT).known == Known::too_short);
      std::get<CellRescaling>(slow.type).time_constant *= 7.0 / 9;
      CHECK(measured_compressibility(v, slow, length, kT).known == Known::yes);
    }
    // Student's t of a few modes exceeds three errors in up to 5 % of cases: of 20, three or more
    // have a probability of 8 %, five of 0.3 %.
    CHECK(far < 5);
  }
}

TEST_CASE("while the volume relaxes, the compressibility is not known and moves grow") {
  const double standard = default_compressibility();
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const EnergyStatistics v = volumes(standard, 0.1, seed);  // 10 %, of fluctuations of 0.4 %
    const auto next = [&](double present) {
      return next_compressibility(v, barostat(present, standard), length, kT) / standard;
    };
    CHECK(measured_compressibility(v, barostat(standard, standard), length, kT).known !=
          Known::yes);
    CHECK(next(standard) == doctest::Approx(4));
    CHECK(next(8 * standard) == doctest::Approx(16));
    CHECK(next(30 * standard) == doctest::Approx(30));
  }
}

TEST_CASE("without moves nothing is known about the compressibility") {
  EnergyStatistics still;
  for (int k = 0; k < 100; ++k) {
    Energies e;
    e.time = 0.02 * k, e.volume = V0;
    still.add(e);
  }
  const double standard = default_compressibility();
  const BarostatSettings usual = barostat(standard, standard);
  CHECK(measured_compressibility(still, usual, length, kT).known != Known::yes);
  CHECK(next_compressibility(still, usual, length, kT) == standard);
  CHECK(next_compressibility({}, usual, length, kT) == standard);
}
