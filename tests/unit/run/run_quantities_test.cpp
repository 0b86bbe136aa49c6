// SPDX-License-Identifier: MIT
// The manual's table of the quantities of a run is made from their list. With
// POLHODE_WRITE_MANUAL=1 in the environment the test brings the table up to date.
#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "polhode/integrate/schemes.hpp"
#include "polhode/run/simulation/report/run_report.hpp"
#include "run/quantity_lists.hpp"

using namespace polhode;

namespace {

/// A run that has every quantity.
RunReport complete() {
  RunReport report{{},   {.scheme = schemes.front()}, {}, RunFileNames(OutputSettings{}), {}, {},
                   false};
  RunSummary& s = report.summary;
  s.shadow.emplace();
  s.step_bias.emplace();
  s.temperatures_at_bath.emplace();
  s.configurational[0] = SeriesEstimate{};
  s.ensemble.settings.thermostat.emplace();
  s.ensemble.settings.barostat.emplace();
  s.ensemble.settings.hybrid_monte_carlo.emplace();
  s.ensemble.barostat.emplace();
  s.ensemble.hybrid_monte_carlo.emplace();
  report.guarantee.emplace();
  return report;
}

void check_unique(const Quantities& list, const std::string& group) {
  std::set<std::string> keys;
  for (const Quantity& q : list) {
    if (q.key.empty()) continue;
    CAPTURE(group + q.key);
    CHECK(keys.insert(q.key + " " + q.unit).second);
    if (const auto* inner = std::get_if<Quantities>(&q.value)) check_unique(*inner, q.key + ".");
  }
}

}  // namespace

TEST_CASE("the manual has the quantities of a run as their list states them") {
  const std::string path = std::string(POLHODE_TEST_DATA) + "/../../docs/manual/outputs.md";
  const std::string begin = "<!-- quantities: run -->\n", end = "<!-- end of quantities -->";
  std::ifstream in(path);
  const std::string page{std::istreambuf_iterator<char>(in), {}};
  const auto first = page.find(begin), last = page.find(end);
  REQUIRE(first != page.npos);
  REQUIRE(last != page.npos);
  const std::string table = documentation(run_quantities(complete()));
  const auto at = first + begin.size();
  if (std::getenv("POLHODE_WRITE_MANUAL"))
    std::ofstream(path) << page.substr(0, at) + table + page.substr(last);
  else
    CHECK(page.substr(at, last - at) == table);
}

TEST_CASE("each quantity of a run is stated once, and is in its JSON") {
  const RunReport report = complete();
  check_unique(run_quantities(report), "");
  const auto json = nlohmann::json::parse(run_json(report));
  for (const Quantity& q : flattened(run_quantities(report)))
    if (!q.key.empty() && q.unit.empty()) CHECK(json.contains(q.key));
  CHECK(json["errors_not_known"]["potential_error_kJ_per_mol"] == "too few samples");
  CHECK(text_of(run_quantities(report)).find("potential energy") != std::string::npos);
}

TEST_CASE("a temperature of one motion without an error has the reason") {
  RunReport report = complete();
  RunSummary& s = report.summary;
  s.degrees_of_freedom.translation = 3;
  s.degrees_of_freedom.rotation = {1, 1, 1};
  s.temperatures.all = s.temperatures.translation = {300, 1, Known::yes};
  s.temperatures.rotation.fill({300, 1, Known::yes});
  const std::string words = "; a missing error is not known: ";
  CHECK(text_of(run_quantities(report)).find(words) == std::string::npos);
  s.temperatures.rotation[1].known = Known::too_short;
  CHECK(text_of(run_quantities(report)).find(words + reason(Known::too_short)) !=
        std::string::npos);
}

TEST_CASE(
    "a row has its value with error and unit, a fraction in percent, and why there is no error") {
  const SeriesEstimate known{0.0123, 0.0004, Known::yes}, unknown{0.0123, 0, Known::too_short};
  CHECK(text_of(Quantities{{"a", "ps", known, "", "time"}}) ==
        "time                  0.01230 ± 0.00040 ps\n");
  CHECK(text_of(Quantities{{"a", "%", known, "", "share"}}) ==
        "share                 1.230 ± 0.040 %\n");
  CHECK(text_of(Quantities{{"a", "%", unknown, "", "share"}}) ==
        "share                 1.23 %, error not known: " + reason(Known::too_short) + "\n");
}
