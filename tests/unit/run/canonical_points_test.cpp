// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "../errors.hpp"
#include "../folder.hpp"
#include "polhode/math/random.hpp"
#include "run/canonical/canonical_report.hpp"
#include "run/study/run_record.hpp"

using namespace polhode;

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

StudySettings study_settings(std::vector<NamedScheme> schemes, std::vector<double> steps) {
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
  const auto methods = canonical_methods(study_settings({"obabo", "hoa2"}, {0.002}));
  REQUIRE(methods.size() == 2);
  CHECK(methods[0].name == "obabo");
  CHECK(!methods[0].hybrid);
  CHECK(methods[1].name == "hmc-hoa2");
  CHECK(methods[1].hybrid);
  CHECK(methods[1].cost() == doctest::Approx(1000));
  CHECK(canonical_methods(StudySettings{}).size() == 3 * canonical_schemes().size());
  check_error([] { canonical_methods(study_settings({"B(1) A(1)"}, {0.002})); }, {"palindrome"});
  CHECK(canonical_methods(study_settings({"gier4-fd"}, {0.002})).front().hybrid);
  check_error([] { canonical_methods(study_settings({"hoa2"}, {0.002, 0.002})); }, {"twice"});
}

TEST_CASE("biases are those of the schemes, with errors that cover them as often as they say") {
  const auto methods = canonical_methods(study_settings({"baoab", "hoa2"}, {0.002, 0.004}));
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

namespace {

/// A point whose bias of U is known to 0.01 kJ/mol, and whose sample takes 2τ/h force evaluations.
CanonicalPoint point_of(const char* scheme, double step, double bias, double tau) {
  CanonicalPoint point{.method = canonical_methods(study_settings({scheme}, {step}))[0]};
  point.runs = 100;
  point.bias[0] = Estimate{bias, 0.01};
  point.correlation_time = {tau, 0.01};
  return point;
}

}  // namespace

TEST_CASE("claims and the table follow one rule, for the strict and the loose bounds") {
  // 500, 250, 167 evaluations per sample by velocity Verlet, 2000 and 1000 by hoa2.
  const CanonicalReport report(
      Config{}, {point_of("baoab", 0.002, 0, 0.5), point_of("baoab", 0.004, 0.1, 0.5),
                 point_of("baoab", 0.006, -0.3, 0.5), point_of("hoa2", 0.002, 0, 1),
                 point_of("hoa2", 0.004, 0, 1)});
  const CanonicalFindings &strict = report.findings[0], &loose = report.findings[1];
  REQUIRE(strict.claims.size() == 2);
  CHECK(strict.claims[0].accurate == 0);
  CHECK(strict.claims[0].beyond == 1);
  CHECK(loose.claims[0].accurate == 1);
  CHECK(loose.claims[0].beyond == 2);
  CHECK(strict.claims[1].accurate == 4);
  CHECK(!strict.claims[1].beyond);
  CHECK(strict.cheapest == 0);
  CHECK(loose.cheapest == 1);
  CHECK(strict.as_cheap.empty());
  CHECK(strict.undecided.empty());
  const auto sentences = canonical_sentences(strict, report.points);
  REQUIRE(sentences.size() == 3);
  CHECK(sentences[0].find("up to 2 fs") != std::string::npos);
  CHECK(sentences[0].find("at 4 fs above: <U> per molecule") != std::string::npos);
  CHECK(sentences[2].find("baoab at 2 fs, 500 ± 10") != std::string::npos);
  CHECK(canonical_sentences(loose, report.points)[0].find("at 6 fs above: <U> per molecule") !=
        std::string::npos);
}

TEST_CASE("a scheme is accurate only up to its first step that is not shown to be") {
  const std::vector<CanonicalPoint> points = {point_of("baoab", 0.006, 0, 0.5),
                                              point_of("baoab", 0.004, 0.05, 0.5),
                                              point_of("baoab", 0.002, 0, 0.5)};
  const CanonicalFindings found(BiasCriterion::strict, points);
  REQUIRE(found.claims.size() == 1);
  CHECK(found.claims[0].accurate == 2);  // by step: 4 fs is undecided, 6 fs does not count
  CHECK(!found.claims[0].beyond);
}

// 95 % confidence: 1.96·√2·5 = 13.9 evaluations at 2 fs and 6.9 at 4 fs.
TEST_CASE("points that cost as much as the cheapest, or may be cheaper, are named") {
  const std::vector<CanonicalPoint> points = {
      point_of("baoab", 0.004, 0, 0.4), point_of("obabo", 0.004, 0, 0.42),
      point_of("aboba", 0.004, 0, 0.5), point_of("hoa2", 0.008, 0.05, 0.4),
      point_of("hoa2", 0.004, 0.05, 0.4)};
  const CanonicalFindings found(BiasCriterion::strict, points);
  CHECK(found.cheapest == 0);
  CHECK(found.as_cheap == std::vector<std::size_t>{1});
  CHECK(found.undecided == std::vector<std::size_t>{3});  // the last one costs twice as much
  const std::string text = canonical_sentences(found, points).back();
  CHECK(text.find("not distinguishable in cost: obabo at 4 fs;") != std::string::npos);
  CHECK(text.find("equally cheap or cheaper, but with biases not known to be below their bounds: "
                  "hmc-hoa2 at 8 fs") != std::string::npos);
}

TEST_CASE("one bias above its bound decides about a point, and a run that blew up does") {
  CanonicalPoint point = point_of("baoab", 0.002, 0, 0.5);
  CHECK(point.accuracy(BiasCriterion::strict) == Accuracy::below);
  point.bias[2] = Estimate{-2, 0.1};  // between 1 K and 3 K
  CHECK(point.accuracy(2, BiasCriterion::strict) == Accuracy::above);
  CHECK(point.accuracy(BiasCriterion::strict) == Accuracy::above);
  CHECK(point.accuracy(BiasCriterion::loose) == Accuracy::below);
  point.bias[2] = Estimate{2, 1};
  CHECK(point.accuracy(BiasCriterion::strict) == Accuracy::undecided);
  CHECK(point.accuracy(BiasCriterion::loose) == Accuracy::undecided);
  point.stable = false;
  CHECK(point.accuracy(BiasCriterion::loose) == Accuracy::above);
}

TEST_CASE("the record of a canonical study is read back, and refused for another study") {
  const Folder folder;
  const std::string path = (folder.path / "runs.csv").string();
  const Provenance provenance{"0", "", "of this test", "", 1};
  Random random(3);
  const CanonicalMethod method = canonical_methods(study_settings({"baoab"}, {0.002}))[0];
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
