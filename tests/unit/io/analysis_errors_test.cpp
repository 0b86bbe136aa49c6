// SPDX-License-Identifier: MIT
// Errors of the observables of trajectories, for motion with known statistics: many short series of
// each kind, whose scatter must equal the reported error.
#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <string>

#include "measure/dielectric.hpp"
#include "measure/displacement.hpp"
#include "measure/reorientation.hpp"
#include "measure/velocity_correlation.hpp"
#include "polhode/io/topology/molecule_file.hpp"
#include "polhode/math/random.hpp"

using namespace polhode;

namespace {

constexpr int series = 200;

struct Calibration {
  double told = 0;   ///< fraction of series with an error
  double mean = 0;   ///< of values with an error
  double ratio = 0;  ///< mean reported error divided by the standard deviation of the values
};

Calibration calibration(const std::function<SeriesEstimate(std::uint64_t seed)>& estimate) {
  double n = 0, sum = 0, squares = 0, stated = 0;
  for (int seed = 0; seed < series; ++seed) {
    const SeriesEstimate e = estimate(static_cast<std::uint64_t>(seed));
    if (e.known != Known::yes) continue;
    ++n, sum += e.value, squares += e.value * e.value, stated += e.error;
  }
  if (n < 2) return {n / series};
  return {n / series, sum / n, stated / n / std::sqrt((squares - sum * sum / n) / (n - 1))};
}

// A standard deviation from 200 series is known to 1/√400, the mean of as many reported errors with
// four degrees of freedom each to 1/√1600: together to 5.6 %. Three times that is allowed.
void check_calibrated(const std::string& what, const Calibration& c) {
  CAPTURE(what);
  CAPTURE(c.told);
  CAPTURE(c.mean);
  CAPTURE(c.ratio);
  CHECK(c.told > 0.9);
  CHECK(c.ratio > 0.83);
  CHECK(c.ratio < 1.17);
}

// Random walkers of variance 2 D = 0.002 nm² per frame along each axis. Optionally all steps have a
// common factor exp(x), with x of variance 0.25 and a correlation time of 5 frames.
SeriesEstimate walk(std::uint64_t seed, std::size_t bodies, int frames, bool shared_pace) {
  const Topology topology{{{read_molecule("argon"), bodies}}};
  State state(bodies, Box{{10, 10, 10}});
  Random random(seed);
  Displacement displacement(topology, 11);
  double x = 0.5 * random.normal();
  for (int t = 0; t < frames; ++t) {
    displacement.add(state);
    const double kept = std::exp(-1 / 5.0);
    x = kept * x + 0.5 * std::sqrt(1 - kept * kept) * random.normal();
    const double step = std::sqrt(0.002) * (shared_pace ? std::exp(x) : 1);
    for (std::size_t i = 0; i < bodies; ++i) {
      const double a = random.normal(), b = random.normal(), c = random.normal();
      state.q.add(i, step * Vec3<double>{a, b, c});
    }
  }
  return diffusion(displacement.mean_square(0), 1, {2, 10});
}

// Bodies that rotate by small random angles: ⟨u · u'⟩ = exp(−2 D_r t), here with a correlation time
// of 10 frames.
void turn(State& state, Random& random) {
  const double angle = std::sqrt(2 * 0.05);  // 2 D_r per frame
  for (std::size_t i = 0; i < state.size(); ++i) {
    const double a = random.normal(), b = random.normal(), c = random.normal();
    const Quaternion<double> by =
        normalized(Quaternion<double>{1, angle * a / 2, angle * b / 2, angle * c / 2});
    state.orientation.set(i, normalized(by * state.orientation[i]));
  }
}

State tops(std::size_t bodies, Random& random) {
  State state(bodies, Box{{2, 2, 2}});
  for (std::size_t i = 0; i < bodies; ++i) state.orientation.set(i, random.orientation());
  return state;
}

TotalDipole::Result dielectric(std::uint64_t seed, int frames, double interval) {
  const Topology topology{{{read_molecule("tip4p"), 3}}};
  Random random(seed);
  State state = tops(3, random);
  TotalDipole dipole(topology);
  for (int t = 0; t < frames; ++t, turn(state, random)) dipole.add(state);
  return dipole.result(300, tin_foil, interval);
}

SeriesEstimate kirkwood(std::uint64_t seed, int frames) {
  return dielectric(seed, frames, 1).kirkwood;
}

SeriesEstimate relaxation(std::uint64_t seed, int frames) {
  const Topology topology{{{read_molecule("tip4p"), 8}}};
  Random random(seed);
  State state = tops(8, random);
  Reorientation reorientation(topology, 61);
  for (int t = 0; t < frames; ++t, turn(state, random)) reorientation.add(state);
  const auto times = relaxation_times(reorientation.legendre(0, 3, 1), 1);
  return times ? times->integral : SeriesEstimate{std::nan("")};
}

}  // namespace

TEST_CASE("random walkers: errors of D are right for equal and for random step lengths") {
  const Calibration own = calibration([](auto seed) { return walk(seed, 6, 600, false); });
  check_calibrated("own pace", own);
  // Relative to the centre of mass of six bodies, 5/6 of the displacements are left; the mean over
  // the series is known to about 1/√(6 · 60 · 200).
  CHECK(own.mean == doctest::Approx(0.001 * 5 / 6).epsilon(0.02));
  check_calibrated("shared pace", calibration([](auto seed) { return walk(seed, 6, 600, true); }));
}

TEST_CASE("rotating dipoles: errors of the Kirkwood factor and of relaxation times") {
  const Calibration dipole = calibration([](auto seed) { return kirkwood(seed, 1500); });
  check_calibrated("Kirkwood factor", dipole);
  // Dipoles are independent; subtracting the mean of M over 75 times of 2 · 10 frames removes 1.3
  // %.
  CHECK(dipole.mean == doctest::Approx(1 - 1 / 75.0).epsilon(0.02));
  const Calibration times = calibration([](auto seed) { return relaxation(seed, 1000); });
  check_calibrated("relaxation time", times);
}

TEST_CASE("short runs report no error") {
  CHECK(walk(1, 6, 11, false).known == Known::too_few_samples);
  // Three correlation times of the dipole: in most runs it has hardly rotated.
  CHECK(calibration([](auto seed) { return kirkwood(seed, 30); }).told < 0.25);
}

TEST_CASE("centre-of-mass motion of the whole system is not diffusion") {
  const Topology topology{{{read_molecule("argon"), 3}, {read_molecule("tip4p"), 2}}};
  State rest(5, Box{{2, 2, 2}}), moving(5, Box{{2, 2, 2}});
  Random random(1);
  const Bodies bodies(topology);
  Displacement a(topology, 10), b(topology, 10);
  VelocityCorrelation v(topology, 10), w(topology, 10);
  const Vec3<double> common{0.7, -1.1, 0.4};  // nm/ps; frames are 0.1 ps apart
  for (int t = 0; t < 40; ++t) {
    a.add(rest), b.add(moving), v.add(rest), w.add(moving);
    for (std::size_t i = 0; i < 5; ++i) {
      const double x = random.normal(), y = random.normal(), z = random.normal();
      const Vec3<double> u{0.3 * x, 0.3 * y, 0.3 * z};
      rest.q.add(i, 0.1 * u);
      moving.q.add(i, 0.1 * (u + common));
      rest.p.set(i, bodies.m[i] * u);
      moving.p.set(i, bodies.m[i] * (u + common));
    }
  }
  for (std::size_t part = 0; part < 2; ++part)
    for (std::size_t lag = 0; lag < 10; ++lag) {
      // Up to the rounding of positions displaced by 5 nm.
      CHECK(std::abs(a.mean_square(part).mean()[lag] - b.mean_square(part).mean()[lag]) < 1e-13);
      CHECK(std::abs(v.linear(part).mean()[lag] - w.linear(part).mean()[lag]) < 1e-13);
    }
}

TEST_CASE("frames without times show as well that the dielectric constant has not converged") {
  const Convergence timed = dielectric(1, 12, 0.5).convergence;
  const Convergence untimed = dielectric(1, 12, 0).convergence;
  CHECK(!timed.converged());
  CHECK(!untimed.converged());
  CHECK(timed.unit == std::string("ps"));
  CHECK(untimed.unit == std::string("frames"));
  CHECK(untimed.length == 12);
  CHECK(untimed.needed == doctest::Approx(timed.needed / 0.5));
}
