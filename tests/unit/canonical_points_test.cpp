// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "errors.hpp"
#include "folder.hpp"
#include "polhode/math/random.hpp"
#include "polhode/run/canonical/canonical_record.hpp"
#include "polhode/run/canonical/canonical_report.hpp"

using namespace polhode;

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

StudySettings settings_of(std::vector<std::string> schemes, std::vector<double> steps) {
  StudySettings settings;
  settings.schemes = std::move(schemes);
  settings.steps = std::move(steps);
  return settings;
}

/// A run of atoms, whose potential energy and temperatures have a bias.
CanonicalRun run_of(const CanonicalMethod& method, int start, double bias, Random& random) {
  CanonicalRun run{.scheme = method.text, .step = method.step, .start = start};
  run.means = {-40 + bias + 0.01 * random.normal(),
               300 + 100 * bias + random.normal(),
               unknown,
               300 + random.normal(),
               unknown,
               3};
  run.correlation_time = 0.5;
  return run;
}

}  // namespace

TEST_CASE("schemes with a bath are Langevin, those without make hybrid Monte Carlo") {
  const auto methods = canonical_methods(settings_of({"obabo", "hoa2"}, {0.002}));
  REQUIRE(methods.size() == 2);
  CHECK(methods[0].name == "obabo");
  CHECK(!methods[0].hybrid);
  CHECK(methods[1].name == "hmc-hoa2");
  CHECK(methods[1].hybrid);
  CHECK(methods[1].cost() == doctest::Approx(1000));
  CHECK(canonical_methods(StudySettings{}).size() == 3 * canonical_schemes().size());
  check_error([] { canonical_methods(settings_of({"gier4-fd"}, {0.002})); }, {"finite difference"});
  check_error([] { canonical_methods(settings_of({"hoa2"}, {0.002, 0.002})); }, {"twice"});
}

TEST_CASE("biases are those of the schemes, with errors that cover them as often as they say") {
  const auto methods = canonical_methods(settings_of({"baoab", "hoa2"}, {0.002, 0.004}));
  constexpr double bias = 0.02;
  int covered = 0, exact_covered = 0;
  constexpr int trials = 400, runs_per_point = 8;
  for (int trial = 0; trial < trials; ++trial) {
    Random random(11, static_cast<std::uint64_t>(trial));
    std::vector<CanonicalRun> runs;
    for (const CanonicalMethod& method : methods)
      for (int start = 0; start < runs_per_point; ++start)
        runs.push_back(run_of(method, start, method.hybrid ? 0 : bias, random));
    const auto points = canonical_points(methods, runs, 300);
    REQUIRE(points.size() == 4);
    CHECK(!points[0].bias[2]);  // atoms do not rotate
    covered += std::abs(points[0].bias[0]->value - bias) < points[0].bias[0]->error;
    exact_covered += std::abs(points[3].bias[0]->value) < points[3].bias[0]->error;
    CHECK(points[0].evaluations_per_sample().value == doctest::Approx(500));
  }
  // Within one standard error of 8 runs: 66 % for the scatter of one point alone (t with 7 degrees
  // of freedom), 68 % in the limit; three standard deviations of 400 trials are 7 %.
  for (const int count : {covered, exact_covered}) {
    CHECK(count > (0.66 - 0.07) * trials);
    CHECK(count < (0.68 + 0.07) * trials);
  }
}

TEST_CASE("a bias is below its bound, above it, or undecided, at 95 %") {
  CHECK(accuracy_of({0.01, 0.01}, 0.05, 100) == Accuracy::below);
  CHECK(accuracy_of({-0.08, 0.01}, 0.05, 100) == Accuracy::above);
  CHECK(accuracy_of({0.04, 0.01}, 0.05, 100) == Accuracy::undecided);
  // Few runs have wide intervals: t = 12.7 for two.
  CHECK(accuracy_of({0.01, 0.01}, 0.05, 2) == Accuracy::undecided);
  CHECK(accuracy_of({0, 0}, 0.05, 1) == Accuracy::undecided);
}

TEST_CASE("claims and the table follow one rule") {
  const auto methods = canonical_methods(settings_of({"baoab", "hoa2"}, {0.002, 0.004}));
  std::vector<CanonicalPoint> points;
  for (const CanonicalMethod& method : methods) {
    CanonicalPoint point{.method = method};
    point.runs = 100;
    const bool biased = !method.hybrid && method.step > 0.003;
    point.bias[0] = Estimate{biased ? 0.2 : 0.0, 0.01};
    point.correlation_time = {method.hybrid ? 1.0 : 0.5, 0.01};
    points.push_back(point);
  }
  const CanonicalReport report(Config{}, points);
  REQUIRE(report.claims.size() == 2);
  CHECK(report.claims[0].accurate == 0);
  CHECK(report.claims[0].beyond == 1);
  CHECK(report.claims[1].accurate == 3);
  CHECK(!report.claims[1].beyond);
  // 2τ/h: 500 for baoab at 2 fs; at 4 fs it would be cheaper, but is biased; hoa2 2000 and 1000.
  CHECK(report.cheapest == 0);
  CHECK(report.as_cheap.empty());
  const auto sentences = canonical_sentences(report);
  REQUIRE(sentences.size() == 3);
  CHECK(sentences[0].find("up to 2 fs") != std::string::npos);
  CHECK(sentences[0].find("at 4 fs above: <U> per molecule") != std::string::npos);
  CHECK(sentences[2].find("baoab at 2 fs, 500 ± 10") != std::string::npos);
}

TEST_CASE("the record of a canonical study is read back, and refused for another study") {
  const Folder folder;
  const std::string path = (folder.path / "runs.csv").string();
  const Provenance provenance{"0", "", "of this test", "", 1};
  Random random(3);
  const CanonicalMethod method = canonical_methods(settings_of({"baoab"}, {0.002}))[0];
  const CanonicalRun run = run_of(method, 1, 0, random);
  CanonicalRun failed = run;
  failed.start = 2, failed.stable = false;
  {
    CanonicalRecord record(path, provenance, false);
    record.add(run);
    record.add(failed);
  }
  const CanonicalRecord again(path, provenance, false);
  REQUIRE(again.known().size() == 2);
  CHECK(again.known()[0].means[0] == run.means[0]);
  CHECK(std::isnan(again.known()[0].means[2]));
  CHECK(again.known()[0].correlation_time == 0.5);
  CHECK(!again.known()[1].stable);
  check_error(
      [&] {
        CanonicalRecord(path, {"0", "", "another", "", 1}, false);
      },
      {"another study"});
}
