// SPDX-License-Identifier: MIT
// States that are read through a postprocessor: the order and the size of their energy errors, and
// runs with such samples.
#include "integrate/postprocessor.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "polhode/base/error.hpp"
#include "polhode/integrate/integrator.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/integrate/step.hpp"
#include "polhode/measure/shadow.hpp"
#include "polhode/run/simulation/trajectory/propagator.hpp"
#include "polhode/run/simulation/trajectory/trajectory.hpp"
#include "rms.hpp"
#include "scenes.hpp"

using namespace polhode;

namespace {

constexpr std::array postprocessed{"velocity-verlet", "takahashi-imada", "takahashi-imada-fd",
                                   "gier4", "gier4-fd"};

/// A harmonic oscillator with H = (p² + q²)/2, as a linear map of (q, p). ∇W = 2q.
struct Oscillator {
  double q, p;
  void drift(double t) { q += t * p; }
  void kick(double t) { p -= t * q; }
  void kick(double t, double xi_h2, Gradient) { p -= t * q * (1 - 2 * xi_h2); }
};

/// Linear maps of (q, p), whose columns are the images of (1, 0) and (0, 1).
using Map = std::array<double, 4>;  // qq, qp, pq, pp
Map operator*(const Map& x, const Map& y) {
  return {x[0] * y[0] + x[1] * y[2], x[0] * y[1] + x[1] * y[3], x[2] * y[0] + x[3] * y[2],
          x[2] * y[1] + x[3] * y[3]};
}
Map operator-(const Map& x, const Map& y) {
  return {x[0] - y[0], x[1] - y[1], x[2] - y[2], x[3] - y[3]};
}
Map map_of(std::span<const Stage> stages, double h) {
  Oscillator a{1, 0}, b{0, 1};
  play(stages, a, h, {});
  play(stages, b, h, {});
  return {a.q, b.q, a.p, b.p};
}
Map inverse(const Map& x) { return {x[3], -x[1], -x[2], x[0]}; }  // of determinant 1

/// The relative difference of the energies of p and q that a map conserves on an ellipse
/// x q² + y p² + 2 z q p: ((x − y)/(x + y), 2z/(x + y)).
std::array<double, 2> eccentricity(const Map& m) {
  // A map with trace 2 cos φ and determinant 1 conserves −m_pq q² + m_qp p² + (m_qq − m_pp) q p.
  const double x = -m[2], y = m[1], z = (m[0] - m[3]) / 2;
  return {(x - y) / (x + y), 2 * z / (x + y)};
}

/// The eccentricity of order h⁴ that the commutators of degree 5 give:
/// E = e₁ [A,[A,[A,[A,B]]]] + e₂ [B,[A,[A,[A,B]]]] + e₃ [B,[B,[A,[A,B]]]] + e₄ [[A,B],[A,[A,B]]].
/// Operators on functions act in the reverse order of maps, which changes the sign of a commutator.
std::array<double, 2> expected_eccentricity(const std::array<double, 4>& e) {
  const auto commutator = [](const Map& x, const Map& y) { return y * x - x * y; };
  const Map A{0, 1, 0, 0}, B{0, 0, -1, 0};
  const Map AB = commutator(A, B), AAB = commutator(A, AB), AAAB = commutator(A, AAB);
  const std::array terms{commutator(A, AAAB), commutator(B, AAAB),
                         commutator(B, commutator(B, AAB)), commutator(AB, AAB)};
  Map error{};
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t i = 0; i < 4; ++i) error[i] += e[k] * terms[k][i];
  // The generator A + B + h⁴ E conserves −g_pq q² + g_qp p² + (g_qq − g_pp) q p.
  return {(-error[2] - error[1]) / 2, (error[0] - error[3]) / 2};
}

double size(const std::array<double, 2>& x) { return std::hypot(x[0], x[1]); }

}  // namespace

TEST_CASE("the fractions of each flow in a postprocessor sum to zero") {
  for (const char* name : postprocessed) {
    const Postprocessor* const known = postprocessor_of(scheme_of(name));
    REQUIRE(known);
    for (const Flow flow : {Flow::drift, Flow::kick})
      CHECK(std::abs(known->stages.total(flow)) < 1e-14);
  }
  for (const char* name : {"hoa2", "position-verlet", "bcss3", "obabo"})
    CHECK(!postprocessor_of(scheme_of(name)));
  CHECK(postprocessor_of(scheme_of("B(1/2) A(1) B(1/2)")));
}

// The coefficients of the remaining commutators are from a computation in the free Lie algebra:
// studies/postprocessors.py. The stages of a postprocessor are not a palindrome, so the next term
// of the eccentricity is of order h⁵; the mean over h and -h does not contain this term. The term
// of order h⁶ has coefficients of 4e-3 at most, which is 2 % of the smallest expected value at h =
// 0.03, and round-off is 1e-16 / h⁴ = 1e-10.
TEST_CASE("for an oscillator the read energy errs by the commutators that remain") {
  struct Case {
    const char* scheme;
    std::array<double, 4> left;
  };
  for (const auto& [name, left] :
       {Case{"velocity-verlet", {1.0416667e-4, -1.0416667e-4, 1.22395833e-3, -1.11979167e-3}},
        Case{"takahashi-imada", {-4.1666667e-4, 4.1666667e-4, -5.5555556e-4, 1.3888889e-4}},
        Case{"gier4", {-6.9444444e-5, 6.9444444e-5, -9.2592593e-5, 2.3148148e-5}}}) {
    CAPTURE(std::string(name));
    const Scheme scheme = scheme_of(name);
    const double h = 0.03, h4 = h * h * h * h;
    std::array<double, 2> read{};
    for (const double t : {h, -h}) {
      const Map K = map_of(scheme.stages(), t);
      const Map P = map_of(postprocessor_of(scheme)->stages.stages(), t);
      const auto found = eccentricity(P * K * inverse(P));
      for (std::size_t i = 0; i < 2; ++i) read[i] += found[i] / (2 * h4);
    }
    const auto expected = expected_eccentricity(left);
    CAPTURE(read[0]);
    CAPTURE(read[1]);
    CAPTURE(expected[0]);
    CHECK(size({read[0] - expected[0], read[1] - expected[1]}) < 0.05 * size(expected));
  }
}

namespace {

struct Fluctuations {
  double energy, shadow;
};

/// Fluctuations over a trajectory that is read through a postprocessor.
Fluctuations read_fluctuations(const scenes::Scene& start, const Scheme& scheme, double h,
                               int steps) {
  scenes::Scene scene = start;
  ForceField forces(scene.topology, scenes::no_truncation(), scene.state.box);
  const Postprocessor& postprocessor = *postprocessor_of(scheme);
  Integrator integrator(scheme, scene.bodies, forces);
  Integrator reader(postprocessor.stages, scene.bodies, forces);
  const ErrorTerms terms = postprocessor.error_terms(error_terms(scheme));
  std::vector<double> energy, shadow;
  for (int n = 0; n < steps; ++n) {
    integrator.advance(scene.state, h);
    State read = scene.state;
    reader.forget();
    reader.advance(read, h);
    const Load& load = reader.load(read);
    const BracketSample sample{energies(read, scene.bodies, load),
                               error_brackets(read, scene.bodies, load, forces)};
    energy.push_back(sample.energies.total());
    shadow.push_back(shadow_energy(sample, terms, h));
  }
  return {fluctuation(energy), fluctuation(shadow)};
}

}  // namespace

// The error of order h² changes by c of the postprocessor, so the shadow energy of the states that
// are read is conserved to O(h⁴). The remaining error of order h⁴ is small, so the next terms
// change the slopes four times as much as in shadow_test.cpp; with half of its steps, the bound is
// the same. Finite differences have a round-off of 1e-16/λ, which is too large for these errors;
// their schemes have the postprocessors of the exact gradients.
TEST_CASE("states that are read conserve their shadow energy to fourth order") {
  for (const char* name : postprocessed) {
    CAPTURE(std::string(name));
    const Scheme scheme = scheme_of(name);
    if (scheme.has(Gradient::finite_difference)) continue;
    const scenes::Scene scene = scenes::water_cluster();
    const Fluctuations coarse = read_fluctuations(scene, scheme, 0.0005, 80);
    const Fluctuations fine = read_fluctuations(scene, scheme, 0.00025, 160);
    CHECK(std::abs(std::log2(coarse.shadow / fine.shadow) - 4) < 0.15);
    if (scheme.name() != "velocity-verlet")  // no error of order h² is left
      CHECK(std::abs(std::log2(coarse.energy / fine.energy) - 4) < 0.15);
  }
}

namespace {

System cluster() {
  const scenes::Scene scene = scenes::water_cluster();
  return {scene.topology, scene.bodies, scene.state, scenes::no_truncation(), 300};
}

}  // namespace

TEST_CASE("a run reads its samples through the postprocessor and has the same trajectory") {
  for (const char* name : postprocessed) {
    CAPTURE(std::string(name));
    TrajectorySettings settings{scheme_of(name), 0.001, 0.04, 0.002};
    std::vector<double> fluctuation_of;
    std::vector<State> last;
    std::vector<std::uint64_t> evaluations, measurements;
    for (const bool processed : {false, true}) {
      settings.processed = processed;
      System system = cluster();
      ForceField forces(system.topology, system.forces, system.state.box);
      std::vector<double> totals;
      Watch watch;
      watch.sample = [&](std::size_t, const State& state, const Energies& now) {
        CHECK(state.time == now.time);
        totals.push_back(now.total());
      };
      const Trajectory t = run_trajectory(system, forces, settings, watch);
      CHECK(totals.size() == 21);
      fluctuation_of.push_back(fluctuation(totals));
      last.push_back(system.state);
      evaluations.push_back(t.force_evaluations);
      measurements.push_back(t.measurements);
    }
    // The forces at the first sample are a part of the integration if the postprocessor uses them.
    CHECK(evaluations[1] - evaluations[0] <= 1);
    const std::uint64_t each = scheme_of(name).order() == 4 ? 5
                               : scheme_of(name).cost() > 1 ? 4
                                                            : 3;
    CHECK(measurements[1] == 21 * each);
    CHECK(fluctuation_of[1] < 0.5 * fluctuation_of[0]);
    for (std::size_t i = 0; i < last[0].size(); ++i)  // there is no list of neighbours to rebuild
      CHECK(norm(last[0].q[i] - last[1].q[i]) == 0);
  }
}

// The shadow energy of a run has the error terms of the states that are read. With the terms of the
// scheme itself it would fluctuate more than the energy.
TEST_CASE("the shadow energy of a run is that of the states that are read") {
  TrajectorySettings settings{scheme_of("velocity-verlet"), 0.001, 0.04, 0.001};
  settings.shadow_sample = 0.001;
  settings.processed = true;
  System system = cluster();
  ForceField forces(system.topology, system.forces, system.state.box);
  std::vector<double> totals, shadows;
  Watch watch;
  watch.sample = [&](std::size_t, const State&, const Energies& now) {
    totals.push_back(now.total());
    shadows.push_back(now.total() + now.step_error);
  };
  run_trajectory(system, forces, settings, watch);
  CHECK(fluctuation(shadows) < 0.1 * fluctuation(totals));
}

TEST_CASE("a run that continues after its last sample has the counts of a longer run") {
  TrajectorySettings settings{scheme_of("velocity-verlet"), 0.001, 0.025, 0.002};
  settings.processed = true;
  std::vector<std::uint64_t> measurements;
  for (const bool ends : {true, false}) {  // with an additional sample after 25 steps
    System system = cluster();
    ForceField forces(system.topology, system.forces, system.state.box);
    Propagator propagator(system, forces, settings);
    if (ends)
      propagator.run();
    else
      propagator.advance(25);
    propagator.advance(5);
    measurements.push_back(propagator.trajectory().measurements);
  }
  CHECK(measurements[0] == 16 * 3);
  CHECK(measurements[1] == 16 * 3);
}

TEST_CASE("settings without a known postprocessor are refused") {
  const auto refusal = [](const char* scheme, const EnsembleSettings& ensemble = {}) {
    TrajectorySettings settings{scheme_of(scheme), 0.001, 0.04, 0.002};
    settings.ensemble = ensemble;
    settings.processed = true;
    settings.check_processed();
  };
  CHECK_THROWS_WITH_AS(refusal("hoa2"), doctest::Contains("no postprocessor is known"), Error);
  for (const EnsembleSettings& ensemble :
       {EnsembleSettings{300, Langevin{}, {}, {}},
        EnsembleSettings{300, {}, BarostatSettings{}, {}},
        EnsembleSettings{300, {}, {}, HybridMonteCarloSettings{}}})
    CHECK_THROWS_WITH_AS(refusal("velocity-verlet", ensemble),
                         doctest::Contains("not at constant energy"), Error);
  CHECK_NOTHROW(refusal("velocity-verlet"));
}

// The states of the Takahashi-Imada scheme have an error of order h², and those that are read have
// none, so they have no shadow energy of their own.
TEST_CASE("the error terms of settings are those of the states that are read") {
  TrajectorySettings settings{scheme_of("takahashi-imada"), 0.001, 0.04, 0.002};
  CHECK(settings.has_shadow());
  settings.processed = true;
  CHECK(!settings.has_shadow());
  settings.scheme = scheme_of("velocity-verlet");
  CHECK(settings.has_shadow());
  CHECK(settings.error_terms().alpha == doctest::Approx(1.0 / 48).epsilon(1e-14));
  CHECK(settings.error_terms().beta == doctest::Approx(1.0 / 48).epsilon(1e-14));
}
