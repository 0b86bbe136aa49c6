// SPDX-License-Identifier: MIT
// The manual's tables of keys are made from the lists of quantities. With POLHODE_WRITE_MANUAL=1 in
// the environment the test brings them up to date.
#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

#include "polhode/integrate/scheme_text.hpp"
#include "polhode/integrate/schemes.hpp"
#include "polhode/run/prepare/minimisation.hpp"
#include "polhode/run/properties/measure.hpp"
#include "polhode/run/simulation/system/single_point.hpp"
#include "polhode/run/study/tune.hpp"
#include "run/adviser/advice_report.hpp"
#include "run/benchmark/benchmark.hpp"
#include "run/bias/log_bias.hpp"
#include "run/canonical/canonical_report.hpp"
#include "run/canonical/hybrid_adviser.hpp"
#include "run/listing/lists.hpp"
#include "run/listing/verification.hpp"
#include "run/properties/property.hpp"
#include "run/quantity_lists.hpp"
#include "run/study/study_report.hpp"

using namespace polhode;

namespace {

/// @param name  of the table, between two comments of the page
void check_manual(const std::string& page_name, const std::string& name, const Quantities& list) {
  CAPTURE(name);
  const std::string path =
      std::string(POLHODE_TEST_DATA) + "/../../docs/manual/" + page_name + ".md";
  const std::string begin = "<!-- quantities: " + name + " -->\n";
  std::ifstream in(path);
  const std::string page{std::istreambuf_iterator<char>(in), {}};
  const auto first = page.find(begin), last = page.find("<!-- end of quantities -->", first);
  REQUIRE(first != page.npos);
  REQUIRE(last != page.npos);
  const auto at = first + begin.size();
  const std::string table = documentation(list);
  if (std::getenv("POLHODE_WRITE_MANUAL"))
    std::ofstream(path) << page.substr(0, at) + table + page.substr(last);
  else
    CHECK(page.substr(at, last - at) == table);
  CHECK(nlohmann::json::parse(json_text(list)).is_object());
  CHECK(!text_of(list).empty());
}

/// Curves of the paper's schemes whose temperatures differ, so that every kind of result is there.
StudyReport study() {
  std::vector<EfficiencyPoint> points;
  for (const char* name : {"velocity-verlet", "hoa2", "gier4-fd"})
    for (const double step : {0.002, 0.003, 0.004, 0.005}) {
      EfficiencyPoint p;
      p.scheme = name;
      p.order = 2;
      p.step = step;
      p.length = 10;
      p.cost = 2 / step;
      p.runs = 4;
      p.ratio = {1e3 * step * step, 1e-4};
      p.drift.p_value = 1;
      p.excess.fill(Estimate{1e5 * step * step, 0.5});
      p.configurational_excess.fill(Estimate{1e5 * step * step, 0.5});
      points.push_back(p);
    }
  return {Config{}, points};
}

AdviceReport advice() {
  AdviserPoint point{0.004, 15, {}, 0.004, true};
  for (const double ratio : {0.0031, 0.0029, 0.003}) {
    Outcome run;
    run.ratio = ratio;
    run.bias.fill(ratio);
    point.runs.push_back(run);
  }
  Advice advice;
  advice.candidates.push_back({"hoa2", scheme_of("hoa2"), {point}, {}, 0.004, 1, {}});
  advice.refused.emplace_back(0, point);
  advice.surpassed.emplace_back(0, point);
  advice.best = advice.runner_up = 0;
  advice.confirmation = point;
  return {advice, {Quality::drift, 1e-4}, 1, {"advice", "none"}};
}

Benchmark benchmark() {
  const Timing one{1e-6, 1.1e-6};
  SystemTiming system{.molecules = 512, .evaluations = {{}}, .steps = {{}}};
  system.evaluations[0].forces = system.steps[0].all = one;
  return {.limits = {{}}, .systems = {system}};
}

TuneResult tuning() {
  const SchemeFamily family = hoa2_family();
  Tuned tuned{
      .reference = "hoa2", .scheme = family.reference(), .parameters = {{"eta", 0.19, 0.01}}};
  return {.settings = {},
          .molecules = 512,
          .covariance = {},
          .short_steps = 0.193,
          .families = {tuned}};
}

MeasureReport measurement() {
  MeasuredPoint point{.at = {300, 0.06}, .molecules = 256, .replicas = 4, .step_max = 0.004};
  point.properties = {{{&property("density")},
                       {997, 0.5, Known::yes, 30},
                       SeriesEstimate{0.1, 0.01, Known::yes, 30}},
                      {{&property("coordination-number")}, {4.5, 0.1, Known::yes, 30}}};
  point.profiles = {{"density", "distance (nm)", "kg/m3", {0.02}, {{1000, 0, Known::yes}}}};
  point.distributions = {{{"OW", "OW"}, {0.002}, {{0, 0, Known::yes}}, {}}};
  MeasureReport report{.points = {point}, .system = "256 spce"};
  report.curves.maxima = {{.fit = {5, 3, 1}}};
  report.curves.slopes = {{.property = &property("expansivity"), .at = point.at, .fit = {5, 3, 1}}};
  return report;
}

}  // namespace

TEST_CASE("the manual has the keys of results as their lists state them") {
  const HybridChoice choice{.step = 0.004, .steps = 8};
  check_manual("study", "study", quantities(study()));
  CanonicalPoint point{.method = canonical_methods(StudySettings{})[0]};
  point.method.hybrid = true;
  check_manual("study", "canonical", quantities(CanonicalReport(Config{}, {point})));
  check_manual("advise", "advice", quantities(advice()));
  check_manual(
      "advise", "hybrid",
      quantities(HybridAdvice{.scheme = "hoa2", .pilots = {choice}, .finalists = {}, .equal = {}}));
  check_manual("tune-scheme", "tuning", quantities(tuning()));
  check_manual("bias", "log bias",
               quantities(LogBias{.energy_unit = "`energy_unit`",
                                  .columns = {{"potential", "kJ/mol", {}, {}, {}}},
                                  .at_constant_temperature = SeriesEstimate{}}));
  check_manual("verify", "verification",
               quantities(Verification{NamedScheme("hoa2"), {{{0.01, 0.1}}, 2}, 2}));
  check_manual("bench", "benchmark", quantities(benchmark(), {"a processor", "avx2", {1}}));
  check_manual("measure", "measurement", quantities(measurement()));
  check_manual("minimise", "minimisation", quantities(MinimisationReport{}));
  const char* const argon =
      "[system]\nmolecules = [{ model = \"argon\", count = 27 }]\nbox = \"2.5 nm\"\n[forces]\n"
      "cutoff = \"1 nm\"";
  check_manual("energy", "energy", quantities(single_point(parse_config(argon, "argon.toml"))));
  check_manual("schemes", "scheme", quantities(schemes.front()));
  check_manual("molecules", "molecule", quantities(find_molecules("tip4p").front()));
}
