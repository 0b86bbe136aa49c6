// SPDX-License-Identifier: MIT
#include "run/study/guideline.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "polhode/integrate/scheme_text.hpp"

using namespace polhode;

namespace {

// Five rms fluctuations during a run of law(), 1 kJ/mol in 10 ps.
const Drift relevant_drift{{0.5, 0.01}, 1e-6};

// Points on an exact law R = c hᵏ.
std::vector<EfficiencyPoint> law(const std::string& scheme, double c, int k, double evaluations) {
  std::vector<EfficiencyPoint> points;
  for (const double fs : {1.0, 2.0, 3.0, 4.0, 6.0, 8.0}) {
    EfficiencyPoint p;
    p.scheme = scheme;
    p.order = scheme_of(scheme).order();
    p.step = fs / 1000;
    p.cost = evaluations / p.step;
    p.runs = 10;
    p.length = 10;
    p.total = 1;
    p.ratio = {c * std::pow(fs, k), 0.02 * c * std::pow(fs, k)};
    points.push_back(p);
  }
  return points;
}

}  // namespace

TEST_CASE("costs are interpolated along the power law, and extrapolated by the order") {
  const auto all = curves(law("velocity-verlet", 2e-3, 2, 1));
  const auto inside = cost_at(all[0], 2e-3 * 2.5 * 2.5);
  REQUIRE(inside);
  CHECK(inside->step == doctest::Approx(0.0025).epsilon(1e-12));
  CHECK(inside->cost == doctest::Approx(400).epsilon(1e-12));
  CHECK(inside->exponent == doctest::Approx(2).epsilon(1e-12));
  CHECK(!inside->extrapolated);
  // 2 % of R between two points changes the step by at most 2 %/2 and at least that divided by √2.
  CHECK(inside->error < 400 * 0.01);
  CHECK(inside->error > 400 * 0.007);
  // Ten runs have nine degrees of freedom; two points of equal weight have those of both.
  CHECK(cost_at(all[0], all[0].points[1].ratio.value)->degrees_of_freedom ==
        doctest::Approx(9).epsilon(1e-9));
  const double halfway = std::sqrt(all[0].points[1].ratio.value * all[0].points[2].ratio.value);
  CHECK(cost_at(all[0], halfway)->degrees_of_freedom == doctest::Approx(18).epsilon(1e-9));
  const auto below = cost_at(all[0], 2e-3 / 4);
  REQUIRE(below);
  CHECK(below->extrapolated);
  CHECK(below->cost == doctest::Approx(2000).epsilon(1e-12));
  const auto above = cost_at(all[0], 1.0);  // the longest step suffices
  REQUIRE(above);
  CHECK(above->at_max_step);
  CHECK(above->step == 0.008);
}

TEST_CASE("a drift matters from one rms fluctuation of the energy during a run") {
  EfficiencyPoint p;
  p.runs = 4;
  p.length = 8;
  p.total = 0.0132;
  // GIER4 at 4 fs in a small study: significant, a third of the fluctuation.
  p.drift = {{0.0006, 0.00006}, 0.002};
  CHECK(p.relative_drift() == doctest::Approx(0.0006 * 8 / 0.0132).epsilon(1e-12));
  CHECK(!p.drifts());
  CHECK(p.conserves());  // 0.36 ± 3.2 × 0.036
  p.drift.rate = {-0.0017, 0.0001};
  CHECK(p.drifts());
  p.drift.p_value = 0.02;
  CHECK(!p.drifts());
  CHECK(!p.conserves());
  p.drift.rate = {0, 0.0006};  // t = 3.18 for three degrees of freedom: up to 1.16
  CHECK(p.relative_drift_bound() == doctest::Approx(3.1824 * 0.0006 * 8 / 0.0132).epsilon(1e-4));
  CHECK(!p.conserves());
  p.runs = 1;
  CHECK(!p.conserves());
}

TEST_CASE("a curve ends where all longer steps drift, or at the first that blows up") {
  auto points = law("hoa2", 3e-4, 2, 2);
  points[2].drift = relevant_drift;
  CHECK(curves(points)[0].usable == 6);  // a lone drift in the middle
  points[3].drift = relevant_drift;
  CHECK(curves(points)[0].usable == 6);
  for (const std::size_t i : {4u, 5u}) points[i].drift = {{0.001, 1e-5}, 1e-6};
  CHECK(curves(points)[0].usable == 6);  // significant, but too small to matter
  for (const std::size_t i : {4u, 5u}) points[i].drift = relevant_drift;
  const auto all = curves(points);
  CHECK(all[0].usable == 2);
  CHECK(cost_at(all[0], points[4].ratio.value)->step == points[1].step);
  points[2].drift = {};
  CHECK(curves(points)[0].usable == 3);
  points[5].stable = false;  // together with the drifts before it
  CHECK(curves(points)[0].usable == 3);
  points[1].stable = false;
  CHECK(curves(points)[0].usable == 1);
  points[0].stable = false;
  CHECK(!cost_at(curves(points)[0], 1e-3));
}

// c₂ h² with 2 evaluations against c₄ h⁴ with 3: equal costs n/h at R* with 2/√(√(R/c₂))... the
// steps are h₂ = √(R/c₂), h₄ = (R/c₄)^(1/4), and 2/h₂ = 3/h₄ gives R* = (2/3)⁴ c₂²/c₄.
TEST_CASE("the crossing of two power laws") {
  const double c2 = 3e-4, c4 = 3e-6;
  auto points = law("hoa2", c2, 2, 2);
  const auto fine = law("gier4", c4, 4, 3);
  points.insert(points.end(), fine.begin(), fine.end());
  const auto all = curves(points);
  const auto crossing = crossover(all[1], all[0]);
  REQUIRE(crossing);
  CHECK(crossing->ratio.value ==
        doctest::Approx(std::pow(2.0 / 3, 4) * c2 * c2 / c4).epsilon(0.003));
  CHECK(crossing->ratio.error > 0);
  const auto table = guidelines(all, {0.5 * crossing->ratio.value, 2 * crossing->ratio.value});
  CHECK(table[0].best == 1);
  CHECK(table[1].best == 0);
}
