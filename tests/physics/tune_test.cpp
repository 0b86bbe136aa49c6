// SPDX-License-Identifier: MIT
// Tuned schemes: systems whose best parameters are known, and one where they are searched for.
#include "polhode/run/study/tune.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "polhode/integrate/scheme_text.hpp"
#include "polhode/run/simulation/trajectory/trajectory.hpp"

using namespace polhode;

namespace {

constexpr double h = 0.01;  // [ps]

// Two oscillators of unit mass with incommensurate frequencies: V = ω²q²/2, V̈ = ω²p², W = ω⁴q²,
// with E − ⟨E⟩ given as a combination of h² V̈ and h² W and a third frequency.
ErrorCovariance oscillators(double in_V, double in_W, double beside) {
  std::vector<BracketSample> samples;
  for (int n = 0; n < 20000; ++n) {
    const double t = 0.0137 * n;
    BracketSample sample{};
    for (const double omega : {3.0, 4.7}) {
      const double q = std::cos(omega * t), p = -omega * std::sin(omega * t);
      sample.energies.van_der_waals += omega * omega * q * q / 2;
      sample.brackets.second_derivative += omega * omega * p * p;
      sample.brackets.W += std::pow(omega, 4) * q * q;
    }
    sample.energies.translation =
        h * h * (in_V * sample.brackets.second_derivative + in_W * sample.brackets.W) +
        beside * std::cos(11.3 * t) - sample.energies.van_der_waals;
    samples.push_back(sample);
  }
  return error_covariance(samples, h);
}

}  // namespace

// Harmonic motion conserves V̈ + W, so only α − β matters: it vanishes at η = (3 − √5)/4. The
// variance is zero there, and a search by values alone finds a minimum of c x² to the root of
// rounding of c, 1e-8.
TEST_CASE("the best scheme of the plain family for harmonic motion is known") {
  const double best = (3 - std::sqrt(5.0)) / 4;
  CHECK(std::abs(best_at_short_steps(oscillators(0, 0, 0), hoa2_family())[0] - best) < 1e-7);
  // and from a run with hoa2, whose energy errs by −h² (α V̈ + β W)
  const Scheme hoa2 = scheme_of("hoa2");
  const ErrorTerms terms = error_terms(hoa2);
  const ErrorCovariance c = oscillators(-terms.alpha, -terms.beta, 0);
  CHECK(std::abs(best_parameters(c, hoa2_family())[0] - best) < 1e-7);
}

// The first step of the search, from η = 0.7 where the variance hardly depends on it, leads to
// negative values of x = η², which has no root.
TEST_CASE("a search does not leave the values for which the text of a scheme has a meaning") {
  const SchemeFamily family("free x = 0.49; b = sqrt(x); B(b) A(1/2) B(1 - 2*b) A(1/2) B(b)");
  const double best = (3 - std::sqrt(5.0)) / 4;
  const double x = best_at_short_steps(oscillators(0, 0, 0), family)[0];
  CHECK(std::abs(std::sqrt(x) - best) < 1e-7);
}

TEST_CASE("an interrupted tuning ends without an error") {
  TuneSettings settings;
  settings.runs = 2;
  Callbacks callbacks;
  callbacks.stop = [] { return true; };
  CHECK(tune(default_config(), settings, callbacks).interrupted);
}

// The contributions of the brackets to the energy are recovered, and an uncorrelated part is left:
// its correlation with the brackets over 270 periods or more is below 1/270.
TEST_CASE(
    "the best scheme of the gradient family removes the correlated part of the error brackets") {
  const Scheme gier4 = scheme_of("gier4");
  const ErrorCovariance c = oscillators(0.002, 0, 1e-5);
  const SchemeFamily family = gier4_family();
  const ErrorTerms terms = error_terms(family.at(best_parameters(c, family))) - error_terms(gier4);
  // V̈ + W is constant: 0.002 of V̈, −0.002 of W and any mixture are the same
  CHECK((terms.alpha - terms.beta) / 0.002 == doctest::Approx(1).epsilon(0.01));
  CHECK(c.variance(terms) / (1e-10 / 2) == doctest::Approx(1).epsilon(0.02));
  CHECK(c.variance({}) > 2 * c.variance(terms));
}

// Liquid argon: R² of members of the family, predicted from one run with hoa2, compared with their
// own runs from the same initial configuration. The prediction neglects how the term of order h⁴
// changes with η, (ω h)² ≈ (10/ps × 0.01 ps)² = 1 % relative, and the covariances come from every
// second energy; trajectories stay close over the 2 ps. Both sides of the minimum are covered.
TEST_CASE("fluctuations of a liquid equal those predicted from one run") {
  const Config config = parse_config(R"(
[system]
molecules = [{ model = "argon", count = 64 }]
density = "1.2 g/cm3"
temperature = "110 K"
seed = 3
[forces]
cutoff = "0.75 nm"
)",
                                     "argon.toml");
  const System start = prepare_start(build_system(config), config, 0, 2, {});
  const Scheme hoa2 = scheme_of("hoa2");
  std::vector<BracketSample> brackets;
  const auto run = [&](const Scheme& scheme, double shadow_sample) {
    System system = start;
    ForceField forces(system.topology, system.forces, system.state.box);
    const Watch watch{.brackets = [&](const BracketSample& sample) { brackets.push_back(sample); }};
    return run_trajectory(system, forces, {scheme, h, 2, h, 1e-4, shadow_sample}, watch);
  };
  run(hoa2, 2 * h);
  const ErrorCovariance c = error_covariance(brackets, h);
  double min_measured = INFINITY, at = 0;
  for (const double eta : {0.15, 0.17, 0.18, 0.185, 0.19, 0.195, 0.2, 0.21, 0.23}) {
    CAPTURE(eta);
    const ErrorTerms terms = error_terms(hoa2_family().at({{eta}})), from = error_terms(hoa2);
    const double predicted =
        std::sqrt(c.variance({terms.alpha - from.alpha, terms.beta - from.beta}) / c.VV);
    const double measured = run(hoa2_family().at({{eta}}), 0).statistics.energies.ratio();
    CHECK(measured == doctest::Approx(predicted).epsilon(0.1));
    if (measured < min_measured) min_measured = measured, at = eta;
  }
  CHECK(std::abs(best_parameters(c, hoa2_family())[0] - at) <=
        0.006);  // the spacing of the grid there
}
