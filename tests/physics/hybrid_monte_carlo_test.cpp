// SPDX-License-Identifier: MIT
// Exact laws of hybrid Monte Carlo: the canonical distribution, with any step.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "hybrid_sampling.hpp"
#include "polhode/base/units.hpp"
#include "polhode/ensemble/hybrid_monte_carlo.hpp"
#include "polhode/ensemble/random_streams.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/math/random.hpp"
#include "scenes.hpp"
#include "unit/errors.hpp"

using namespace polhode;

namespace {

using scenes::kelvin;
using scenes::kT;
// Of gradient kicks by finite difference: far from the derivative, so that they are no gradients.
constexpr double lambda = 1;
constexpr double spring = 2000, stiffening = 4e4;  // k/2 q² + b/4 q⁴ [kJ/mol/nm², kJ/mol/nm⁴]

// A well for every body, for each coordinate; U = Σ k q²/2 + b q⁴/4.
void well(const State& state, Load& load) {
  load.van_der_waals = 0;
  for (std::size_t i = 0; i < state.size(); ++i) {
    Vec3<double> f;
    for (std::size_t c = 0; c < 3; ++c) {
      const double q = state.q[i][c], b = stiffening;
      f[c] = -(spring + b * q * q) * q;
      load.van_der_waals += (spring / 2 + b / 4 * q * q) * q * q;
    }
    load.f.set(i, f);
  }
}

// ⟨q²⟩ of one coordinate, by the midpoint rule, which converges exponentially for such integrals.
double exact_square() {
  double weight = 0, squares = 0;
  for (double q = -0.3; q < 0.3; q += 1e-4) {
    const double w = std::exp(-(spring / 2 + stiffening / 4 * q * q) * q * q / kT);
    weight += w, squares += w * q * q;
  }
  return squares / weight;
}

struct Sampled {
  SeriesEstimate square, weight;
  double accepted;
};

Sampled sampled(const char* scheme, double omega_h, double refresh) {
  const scenes::Scene scene = scenes::lattice({{"argon", 4}}, 0.01, 100, 1);
  const double h = omega_h / std::sqrt(spring / scene.bodies.m[0]);
  const HybridMonteCarloSettings settings{.steps = 3, .refresh = refresh};
  HybridMonteCarlo hybrid(settings, kelvin, scene.bodies, 5, Workers::serial(),
                          TotalMomentum::free);
  Integrator integrator(scheme_of(scheme), scene.bodies, well, lambda);
  State state = scene.state;
  TimeBlocks blocks;
  constexpr std::uint64_t trajectories = 40000;
  sample_hybrid(hybrid, integrator, state, {h, 3, trajectories},
                [&](const State& now, const Load&) {
                  double square = 0;
                  for (std::size_t i = 0; i < now.size(); ++i) square += norm2(now.q[i]) / 12;
                  blocks.add(std::array{square});
                });
  const auto first = [](auto mean) { return mean[0]; };
  return {series_estimate(blocks.means(), first),
          series_estimate(hybrid.memory().weights.means(), first),
          double(hybrid.memory().accepted) / trajectories};
}

}  // namespace

// Steps not far below the bound of stability: many proposals are rejected, and nothing is biased. A
// deviation of 4 standard errors, known to 20 %, occurs by chance in 1 of 1,000 checks. Where fewer
// than half of the proposals are accepted, the mean of exp(−ΔH/kT) is that of rare ones, and its
// error unknown.
TEST_CASE(
    "hybrid Monte Carlo samples an anharmonic well exactly, with steps near the stability bound") {
  const double exact = exact_square();
  for (const auto& [scheme, omega_h] :
       {std::pair{"velocity-verlet", 0.9}, {"hoa2", 1.6}, {"blanes-moan4", 2.5}, {"gier4-fd", 2.4}})
    for (const double refresh : {1.0, 0.4}) {
      CAPTURE(std::string(scheme));
      CAPTURE(refresh);
      const Sampled s = sampled(scheme, omega_h, refresh);
      CAPTURE(s.square.value / exact);
      CAPTURE(s.square.error / exact);
      CAPTURE(s.weight.value);
      CAPTURE(s.weight.error);
      CAPTURE(s.accepted);
      CHECK(std::abs(s.square.value - exact) < 4 * s.square.error);
      CHECK(s.square.error < 0.02 * exact);
      CHECK(std::abs(s.weight.value - 1) < 4 * s.weight.error);
      CHECK(s.accepted < 0.95);
      CHECK(s.accepted > 0.5);
    }
}

// One axis of each body in a field, U = −a kT cos θ: ⟨cos θ⟩ = coth a − 1/a, whatever the moments
// of inertia. The fourth-order gradient kick by finite difference displaces bodies about their
// axes.
TEST_CASE("hybrid Monte Carlo samples rotors in a field exactly, with gradient kicks as well") {
  constexpr double a = 8, exact = 1 / 0.99999977 - 1 / a;  // coth 8
  for (const char* molecule : {"n2", "tip4p"})
    for (const auto& [scheme, omega_h] : {std::pair{"hoa2", 1.6}, {"gier4-fd", 2.0}}) {
      CAPTURE(std::string(molecule));
      CAPTURE(std::string(scheme));
      const scenes::Scene scene = scenes::lattice({{molecule, 6}}, 0.4, 3, 2);
      const Vec3<double> J = scene.bodies.J[0];
      // The axis of a linear body, and any axis of another.
      const Vec3<double> axis = J.y == 0   ? Vec3<double>{0, 1, 0}
                                : J.z == 0 ? Vec3<double>{0, 0, 1}
                                           : Vec3<double>{1, 0, 0};
      const auto field = [&](const State& state, Load& load) {
        load.van_der_waals = 0;
        for (std::size_t i = 0; i < state.size(); ++i) {
          const Vec3<double> e = to_lab(state.orientation[i], axis);
          load.van_der_waals -= a * kT * e.z;
          load.tau.set(i, a * kT * cross(e, Vec3<double>{0, 0, 1}));
        }
      };
      double least = std::max({J.x, J.y, J.z});
      for (const double moment : {J.x, J.y, J.z})
        if (moment > 0) least = std::min(least, moment);
      const double h = omega_h * std::sqrt(least / (a * kT));
      HybridMonteCarlo hybrid({.steps = 3}, kelvin, scene.bodies, 5);
      Integrator integrator(scheme_of(scheme), scene.bodies, field, lambda);
      State state = scene.state;
      TimeBlocks blocks;
      std::size_t n = 0;
      sample_hybrid(hybrid, integrator, state, {h, 3, 20000}, [&](const State&, const Load& load) {
        if (++n > 500) blocks.add(std::array{-load.van_der_waals / (a * kT * 6)});
      });
      const SeriesEstimate cosine =
          series_estimate(blocks.means(), [](auto mean) { return mean[0]; });
      const SeriesEstimate weight =
          series_estimate(hybrid.memory().weights.means(), [](auto mean) { return mean[0]; });
      CAPTURE(cosine.value / exact);
      CAPTURE(cosine.error / exact);
      CAPTURE(weight.value);
      CAPTURE(weight.error);
      CAPTURE(double(hybrid.memory().accepted) / 20000);
      CHECK(std::abs(cosine.value - exact) < 4 * cosine.error);
      CHECK(cosine.error < 2e-3 * exact);
      CHECK(std::abs(weight.value - 1) < 4 * weight.error);
      CHECK(hybrid.memory().accepted < 0.995 * 20000);
      CHECK(hybrid.memory().accepted > 0.5 * 20000);
    }
}

TEST_CASE("a rejected trajectory returns to its begin, with opposite momenta") {
  const scenes::Scene scene = scenes::lattice({{"tip4p", 4}}, 0.4, 3, 1);
  HybridMonteCarlo hybrid({}, kelvin, scene.bodies, 5);
  State state = scene.state;
  Load load(4), end(4);
  load.coulomb = 1;
  hybrid.begin(state, load, 0);
  const State begin = state;
  state.q.set(0, {1, 2, 3});
  state.time = 7;
  end.coulomb = 1e9;
  CHECK_FALSE(hybrid.end(state, end, 10));
  CHECK(end.coulomb == 1);
  CHECK(state.time == 7);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(state.q[i] == begin.q[i]);
    CHECK(state.p[i] == -1.0 * begin.p[i]);
    CHECK(state.ell[i] == -1.0 * begin.ell[i]);
  }
}

// With ΔH = kT ln 2, half of the trajectories are accepted: two seeds decide alike on 60 of them by
// chance in 1 of 10¹⁸ tests.
TEST_CASE("hybrid Monte Carlo has other random numbers for each seed and step") {
  const scenes::Scene scene = scenes::lattice({{"tip4p", 4}}, 0.4, 3, 1);
  struct Drawn {
    std::vector<bool> decisions;
    std::vector<double> momenta;
    bool operator==(const Drawn&) const = default;
  };
  const auto drawn = [&](std::uint64_t seed, std::uint64_t first) {
    HybridMonteCarlo hybrid({}, kelvin, scene.bodies, seed);
    Drawn all;
    for (std::uint64_t step = first; step < first + 60; ++step) {
      State state = scene.state;
      Load begin(4), end(4);
      end.coulomb = kT * std::log(2.0);
      hybrid.begin(state, begin, step);
      all.momenta.push_back(state.p[1].x);
      all.decisions.push_back(hybrid.end(state, end, step));
    }
    return all;
  };
  const Drawn one = drawn(3, 0);
  CHECK(drawn(3, 0) == one);
  std::vector<bool> by_momenta;  // what decisions with a number of a draw of momenta would be
  for (std::uint64_t step = 0; step < 60; ++step)
    by_momenta.push_back(Random(3, stream_of(RandomUse::hybrid_momenta, {step, 0})).uniform() <
                         0.5);
  CHECK(one.decisions != by_momenta);
  for (const Drawn& other : {drawn(4, 0), drawn(3, 1ull << 33)}) {
    CHECK(other.decisions != one.decisions);
    for (std::size_t n = 0; n < 60; ++n) CHECK(other.momenta[n] != one.momenta[n]);
  }
}

TEST_CASE("hybrid Monte Carlo refuses schemes that would bias it, with the reason") {
  CHECK_NOTHROW(check_hybrid(scheme_of("gier4")));
  CHECK_NOTHROW(check_hybrid(scheme_of("gier4-fd")));
  check_error([] { check_hybrid(scheme_of("B(1) A(1)")); }, {"palindrome", "hoa2"});
  check_error([] { check_hybrid(scheme_of("baoab")); }, {"draws all momenta", "without stages O"});
}
