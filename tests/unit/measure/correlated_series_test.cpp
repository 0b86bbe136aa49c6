// SPDX-License-Identifier: MIT
// Errors and slopes of series whose correlation is known: calibrated over many series, from both
// sides.
#include "polhode/measure/slope.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "polhode/base/units.hpp"
#include "polhode/math/random.hpp"

using namespace polhode;

namespace {

/// A stationary series of variance 1 with the correlation ρᵗ cos ωt, by rotation and decay of a
/// complex number; ω = 0 is AR(1), ρ = 0 white noise.
class Series {
 public:
  Series(double rho, double omega, std::uint64_t seed)
      : random_(seed), rho_(rho), cos_(std::cos(omega)), sin_(std::sin(omega)) {
    x_ = random_.normal(), y_ = random_.normal();
  }
  double next() {
    const double s = std::sqrt(1 - rho_ * rho_), x = rho_ * (cos_ * x_ - sin_ * y_);
    y_ = rho_ * (sin_ * x_ + cos_ * y_) + s * random_.normal();
    x_ = x + s * random_.normal();
    return x_;
  }
  double normal() { return random_.normal(); }

 private:
  Random random_;
  double rho_, cos_, sin_, x_, y_;
};

struct Settings {
  double rho = 0, omega = 0;
  int length = 1000;
  double drift = 0;  ///< per sample
  double walk = 0;   ///< rms step
  /// What the drift test knows about the walk.
  enum class Walk { known, ignored, unknown_strength, of_another } told = Walk::known;
};

/// Statistics of the estimates over many series.
struct Calibration {
  static constexpr int series = 2000;
  double told = 0;            ///< fraction that is not too short
  double walks = 0;           ///< fraction with a random walk
  double walk = 0;            ///< mean of its variance per time
  double at_5 = 0, at_1 = 0;  ///< fractions with a p-value below 0.05 and 0.01
  double ratio = 0;           ///< rms reported error of the mean divided by the rms of the mean
  double spread = 0;          ///< the same of the slope
};

/// Of a second quantity that performs the same walk, like the shadow energy.
constexpr double shadow_noise = 0.05;

Drift drift_of(const BlockMeans& blocks, const Settings& s) {
  switch (s.told) {
    case Settings::Walk::known:
      return series_drift(blocks, 0, 1, std::array{WalkStrength{1, s.walk * s.walk}});
    case Settings::Walk::ignored:
      return series_drift(blocks, 0, 1);
    case Settings::Walk::unknown_strength:
      return series_drift_over_walk(blocks, 0, 1);
    case Settings::Walk::of_another:
      return series_drift(blocks, 0, 1, walk_strengths(blocks, 0, 2));
  }
  return {};
}

Calibration calibrated(const Settings& s) {
  Calibration c;
  double stated = 0, real = 0, means = 0, slopes = 0, slope_errors = 0;
  for (int n = 0; n < Calibration::series; ++n) {
    Series series(s.rho, s.omega, static_cast<std::uint64_t>(n));
    TimeBlocks blocks;
    double walked = 0;
    for (int t = 0; t < s.length; ++t) {
      const double noise = series.next();
      blocks.add(std::array{double(t), noise + s.drift * t + walked,
                            shadow_noise * series.normal() + walked});
      if (s.walk > 0) walked += s.walk * series.normal();
    }
    const Drift drift = drift_of(blocks.means(), s);
    if (drift.known == Known::yes) {
      c.told += 1.0 / Calibration::series;
      slopes += drift.rate.value * drift.rate.value;
      slope_errors += drift.rate.error * drift.rate.error;
    }
    if (drift.walk > 0) c.walks += 1.0 / Calibration::series;
    c.walk += drift.walk / Calibration::series;
    if (drift.p_value < 0.05) c.at_5 += 1.0 / Calibration::series;
    if (drift.p_value < 0.01) c.at_1 += 1.0 / Calibration::series;
    const SeriesEstimate mean = series_estimate(blocks.means(), [](auto m) { return m[1]; });
    if (mean.known != Known::yes) continue;
    ++means;
    stated += mean.error * mean.error;
    real += mean.value * mean.value;
  }
  if (means > 0) c.ratio = std::sqrt(stated / real);
  if (c.walks > 0) c.walk /= c.walks;
  if (c.told > 0) c.spread = std::sqrt(slope_errors / slopes);
  return c;
}

}  // namespace

// Over 2000 series a fraction of 0.01 is known to 0.0022. At most twice the nominal fractions, from
// sixteen correlation times on (docs/statistics.md). The test is cautious where the noise is white,
// because it allows for noise that is not; the lower side is "an energy drift is detected".
TEST_CASE(
    "without an energy drift, the test for one gives false positives at its stated rate, for any "
    "correlation time") {
  for (const Settings& s :
       {Settings{.rho = 0}, Settings{.rho = std::exp(-1.0 / 8)},
        Settings{.rho = std::exp(-1.0 / 25)}, Settings{.rho = std::exp(-1.0 / 62)},
        Settings{.rho = std::exp(-1.0 / 8), .omega = 0.3},
        Settings{.rho = std::exp(-1.0 / 25), .omega = 0.3},
        Settings{.rho = std::exp(-1.0 / 8), .length = 100}}) {
    const Calibration c = calibrated(s);
    INFO("rho " << s.rho << ", omega " << s.omega << ", length " << s.length << ": fired " << c.at_5
                << " and " << c.at_1 << ", told " << c.told);
    CHECK(c.at_5 < 2 * 0.05);
    CHECK(c.at_1 < 2 * 0.01);
    CHECK(c.told > 0.7);
  }
}

// Errors of means and slopes over their true scatter. Each of 2000 errors of a mean is known to
// 1/√8 to 1/√16, so their average to 1 %; 0.9 to 1.15 is what the modes and their extrapolation
// make of series of 40 correlation times and more, by the same calculation with exact variances.
// The error of a slope allows for slow noise that these series do not have: it is 1.3 to 1.5 times
// the scatter, which the test counts.
TEST_CASE("stated errors equal the scatter of the series") {
  for (const Settings& s :
       {Settings{.rho = 0}, Settings{.rho = std::exp(-1.0 / 8)},
        Settings{.rho = std::exp(-1.0 / 25)}, Settings{.rho = std::exp(-1.0 / 8), .omega = 0.3}}) {
    const Calibration c = calibrated(s);
    INFO("rho " << s.rho << ", omega " << s.omega << ": mean " << c.ratio << ", slope "
                << c.spread);
    CHECK(c.ratio > 0.9);
    CHECK(c.ratio < 1.15);
    CHECK(c.spread > 0.9);
    CHECK(c.spread < 1.6);
  }
}

// An AR(1) series with ρ = exp(−1/8) has τ = 1/2 + ρ/(1 − ρ) = 8.01. The variance of a mean is
// overestimated by up to 1.25, and is known from four to eight modes, to 50 to 71 %; the mean of
// 2000 estimates is known to 2 %.
TEST_CASE("the autocorrelation time from the error of a mean is that of the series") {
  for (const double rho : {0.0, std::exp(-1.0 / 8)}) {
    const double exact = 0.5 + rho / (1 - rho);
    double sum = 0, squares = 0, stated = 0, count = 0;
    for (int n = 0; n < 2000; ++n) {
      Series series(rho, 0, static_cast<std::uint64_t>(n));
      TimeBlocks blocks;
      for (int t = 0; t < 1000; ++t) {
        const double x = series.next();
        blocks.add(std::array{x, x * x});
      }
      const SeriesEstimate mean = series_estimate(blocks.means(), [](auto m) { return m[0]; });
      const double square = blocks.means().mean()[1];
      const SeriesEstimate tau = correlation_time(mean, square - mean.value * mean.value, 1000);
      if (tau.known != Known::yes) continue;
      ++count, sum += tau.value, squares += tau.value * tau.value, stated += tau.error * tau.error;
    }
    const double mean = sum / count, scatter = std::sqrt(squares / count - mean * mean);
    INFO("rho " << rho << ": " << mean / exact << " of τ, stated / scatter "
                << std::sqrt(stated / count) / scatter << ", known " << count / 2000);
    CHECK(mean > 0.95 * exact);
    CHECK(mean < 1.25 * exact);
    CHECK(std::sqrt(stated / count) > 0.85 * scatter);
    CHECK(std::sqrt(stated / count) < 1.4 * scatter);
    CHECK(count > 0.95 * 2000);
  }
  CHECK(correlation_time({0, 0.1, Known::too_short}, 1, 100).known == Known::too_short);
  CHECK(correlation_time({0, 0, Known::yes}, 0, 100).known == Known::not_defined);
}

// Of 10,000 means 27 ± 5 exceed three standard deviations of a normal distribution. Three times the
// error, which is estimated from four or eight modes, would be exceeded in 170 to 400.
TEST_CASE("the bound of three standard deviations is exceeded in 0.27 % of series") {
  for (const double time : {0.1, 8.0, 25.0}) {
    constexpr int all = 10000;
    int beyond = 0;
    for (int n = 0; n < all; ++n) {
      Series series(std::exp(-1 / time), 0, static_cast<std::uint64_t>(n));
      TimeBlocks blocks;
      for (int t = 0; t < 1000; ++t) blocks.add(std::array{series.next()});
      const SeriesEstimate mean = series_estimate(blocks.means(), [](auto m) { return m[0]; });
      if (mean.known == Known::yes && std::abs(mean.value) > three_sigma(mean)) ++beyond;
    }
    INFO("correlation time " << time << ": " << beyond);
    CHECK(beyond > 27 - 4 * 5);
    CHECK(beyond < 27 + 4 * 5);
  }
}

// White noise on 1000 samples gives a slope to √12/1000^1.5; of drifts of eight times that nine of
// ten must be seen at 0.01. Noise of correlation time τ ≫ 1 knows it to √(2 τ) times as much.
TEST_CASE("a drift is detected") {
  const double error = std::sqrt(12) / std::pow(1000, 1.5);
  CHECK(calibrated({.drift = 8 * error}).at_1 > 0.9);
  CHECK(calibrated({.rho = std::exp(-1.0 / 8), .drift = 8 * std::sqrt(16) * error}).at_1 > 0.9);
}

// A series of two correlation times gives no estimate, which is mostly reported.
TEST_CASE("a series that is correlated over its whole length is reported as too short") {
  const Calibration c = calibrated({.rho = std::exp(-1.0 / 500)});
  INFO(c.told);
  CHECK(c.told < 0.5);
  TimeBlocks blocks;
  for (int t = 0; t < int(min_samples) - 1; ++t) blocks.add(std::array{double(t), double(t % 3)});
  CHECK(series_drift(blocks.means(), 0, 1).known == Known::too_few_samples);
  CHECK(!series_drift(blocks.means(), 0, 1).significant());
  blocks.add(std::array{double(min_samples), 0.0});
  CHECK(series_drift(blocks.means(), 0, 1).known != Known::too_few_samples);
  CHECK(series_estimate({}, [](auto m) { return m[0]; }).known == Known::too_few_samples);
}

// Rounding in mixed precision: a walk over correlated noise, of up to ten times its rms. With the
// variance of the walk known, the drift test has its nominal rate; without, a much higher one.
TEST_CASE("a random walk is not reported as a drift") {
  for (const double step : {0.03, 0.3}) {
    Settings s{.rho = std::exp(-1.0 / 8), .walk = step};
    const Calibration known = calibrated(s);
    INFO("step " << step << ": " << known.at_5 << ", " << known.at_1);
    CHECK(known.at_5 < 2 * 0.05);
    CHECK(known.at_1 < 2 * 0.01);
    CHECK(known.spread > 0.9);
    CHECK(known.spread < 1.6);
  }
  const Calibration unknown =
      calibrated({.rho = std::exp(-1.0 / 8), .walk = 0.3, .told = Settings::Walk::ignored});
  CHECK(unknown.at_1 > 2 * 0.01);
}

// A walk of unknown strength, as of conserved energies. White noise of variance 1 on n samples
// gives c₁ the variance 1, a walk of rms step s gives it s² n²/10: here 0.6 to 10⁵ times as much.
// The test is conservative only where the walk is too weak to be seen, up to 10.
TEST_CASE("a random walk of unknown strength is not reported as a drift") {
  for (const double step : {0.0025, 0.01, 0.03, 0.1, 1.0}) {
    const Calibration c = calibrated({.walk = step, .told = Settings::Walk::unknown_strength});
    INFO("step " << step << ": " << c.at_5 << ", " << c.at_1 << ", error divided by scatter "
                 << c.spread << ", found " << c.walks);
    CHECK(c.told == doctest::Approx(1));
    CHECK(c.at_5 < 2 * 0.05);
    CHECK(c.at_1 < 2 * 0.01);
    CHECK(c.spread > 0.9);
    CHECK(c.spread < (step < 0.005 ? 3 : 1.6));
    if (step < 0.02) continue;
    CHECK(c.at_5 > 0.5 * 0.05);
    CHECK(c.at_1 > 0.3 * 0.01);
  }
  // Without a walk the test is conservative, but it detects an energy drift of 16 errors of white
  // noise.
  const double error = std::sqrt(12) / std::pow(1000, 1.5);
  CHECK(calibrated({.told = Settings::Walk::unknown_strength}).at_5 < 0.05);
  CHECK(calibrated({.drift = 16 * error, .told = Settings::Walk::unknown_strength}).at_1 > 0.9);
}

// Slow noise besides the walk counts as a part of it, so the test can only become more cautious.
TEST_CASE("a random walk over correlated noise is not reported as a drift") {
  for (const double time : {8.0, 62.0})
    for (const double step : {0.03, 0.3}) {
      const Calibration c = calibrated(
          {.rho = std::exp(-1 / time), .walk = step, .told = Settings::Walk::unknown_strength});
      INFO("correlation time " << time << ", step " << step << ": " << c.at_5 << ", " << c.at_1
                               << ", error divided by scatter " << c.spread);
      CHECK(c.at_5 < 2 * 0.05);
      CHECK(c.at_1 < 2 * 0.01);
      CHECK(c.spread > 0.9);
    }
}

// The slowest ten modes of a walk of step 0.3 are above the white noise, (π k)² < n² s²: they know
// its variance to √(2/10), so the mean over series is within a part of that.
TEST_CASE("a random walk is found where there is one, with its strength") {
  const Calibration walk = calibrated({.walk = 0.3, .told = Settings::Walk::unknown_strength});
  CHECK(walk.walks > 0.9);
  CHECK(walk.walk == doctest::Approx(0.09).epsilon(std::sqrt(2 / 10.0)));
  for (const double time : {0.1, 8.0}) {
    const Calibration none =
        calibrated({.rho = std::exp(-1 / time), .told = Settings::Walk::unknown_strength});
    INFO("correlation time " << time);
    CHECK(none.walks < 0.1);
  }
}

// The energy performs the walk of the shadow energy with additional noise: in 27 TIP4P waters, HOA2
// at 4 fs, the walk contributes half of the variance of the slope over 100 ps, and less over
// shorter runs. Here white noise gives c₁ the variance 1 and the walk s² n²/10: 0.1, 0.9 and 10.
TEST_CASE("the random walk of the shadow energy is not reported as an energy drift") {
  for (const double step : {0.001, 0.003, 0.01}) {
    const Calibration c = calibrated({.walk = step, .told = Settings::Walk::of_another});
    INFO("step " << step << ": " << c.at_5 << ", " << c.at_1 << ", error divided by scatter "
                 << c.spread);
    CHECK(c.told > 0.9);
    CHECK(c.at_5 < 2 * 0.05);
    CHECK(c.at_1 < 2 * 0.01);
    CHECK(c.spread > 0.9);
    CHECK(c.spread < 1.6);
  }
  CHECK(calibrated({.walk = 0.01, .told = Settings::Walk::ignored}).at_1 > 2 * 0.01);
}
