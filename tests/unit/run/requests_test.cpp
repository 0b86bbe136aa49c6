// SPDX-License-Identifier: MIT
// Requests of jobs, as a front end fills them: each option has its bounds, and errors name it.
#include "run/requests.hpp"

#include <doctest/doctest.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "polhode/base/error.hpp"
#include "run/analysis/analysis_request.hpp"

namespace polhode {
namespace {

template <class Request>
Request filled(const std::vector<std::pair<std::string, std::string>>& texts) {
  Request request;
  for (const RequestOption<Request>& row : Request::options()) {
    (request.*row.member).name = row.name;
    for (const auto& [name, text] : texts)
      if (name == row.name) (request.*row.member).text = text;
  }
  return request;
}

std::string refusal(const std::function<void()>& read) {
  try {
    read();
  } catch (const Error& e) {
    return e.what();
  }
  return "";
}

struct Case {
  std::string name, text, words;
};

}  // namespace

TEST_CASE("bounds of the adviser's options") {
  const Config config = default_config();
  for (const Case& one : {Case{"accuracy", "200 %", "accuracy = \"200 %\""},
                          {"accuracy", "0 %", "must be"},
                          {"drift", "0 kJ/mol/ns", "above 0 kJ/mol/ns"},
                          {"temperature_bias", "101 %", "must be"},
                          {"time", "0", "from 0.1 to 1000000"},
                          {"time", "x", "must be a number"},
                          {"evaluations", "99", "from 100 to"},
                          {"ensemble", "npt", "nve"}}) {
    const auto request =
        filled<AdviceRequest>({{"bias", one.name == "time" ? "0.1 K" : ""}, {one.name, one.text}});
    CAPTURE(one.name);
    const bool is_hybrid = one.name == "evaluations";
    const std::string said = refusal([&] {
      if (is_hybrid)
        request.hybrid_settings(config, false, {});
      else if (!request.is_canonical())
        request.settings(config);
    });
    CHECK(said.find(one.words) != said.npos);
  }
  CHECK(refusal([&] { filled<AdviceRequest>({}).settings(config); }).find("no accuracy") == 0);
  CHECK(refusal([&] {
          filled<AdviceRequest>({{"accuracy", "1 %"}, {"bias", "0.1 K"}}).settings(config);
        }).find("accuracy excludes bias") != std::string::npos);
}

TEST_CASE("options of the adviser that do not apply to the ensemble are refused") {
  const Config config = default_config();
  for (const Case& one : {Case{"accuracy", "1 %", "hybrid Monte Carlo is exact at any step"},
                          {"drift", "1 kJ/mol/ns", "exact at any step"},
                          {"temperature_bias", "1 %", "exact at any step"},
                          {"bias", "0.1 K", "exact at any step"},
                          {"time", "10", "number of force evaluations determines the length"},
                          {"output", "mine", "no file is written"}}) {
    CAPTURE(one.name);
    const auto request = filled<AdviceRequest>({{"ensemble", "nvt"}, {one.name, one.text}});
    const std::string said = refusal([&] { request.hybrid_settings(config, false, {}); });
    CHECK(said.find(one.name + " = \"" + one.text + "\" has no meaning with ensemble \"nvt\"") ==
          0);
    CHECK(said.find(one.words) != said.npos);
  }
  const auto nvt = filled<AdviceRequest>({{"ensemble", "nvt"}, {"evaluations", "1000"}});
  CHECK(refusal([&] {
          nvt.hybrid_settings(config, false, {"5 ps", "length"});
        }).find("length = \"5 ps\" has no meaning") == 0);
  CHECK(nvt.hybrid_settings(config, false, {}).evaluations == 1000);
  const auto nve = filled<AdviceRequest>({{"accuracy", "1 %"}, {"evaluations", "1000"}});
  CHECK(refusal([&] {
          nve.settings(config);
        }).find("evaluations = \"1000\" applies only to hybrid Monte Carlo") == 0);
}

TEST_CASE("bounds of the options of an analysis") {
  for (const Case& one : {Case{"cutoff", "0.001 nm", "shorter than a bin"},
                          {"cutoff", "0 nm", "above 0 nm"},
                          {"bin", "-1 nm", "above 0 nm"},
                          {"window", "0 ps", "longer than 0"},
                          {"interval", "1 nm", "time"},
                          {"fit", "2 ps", "two lags"},
                          {"fit", "3 ps, 2 ps", "end at a later lag"},
                          {"pairs", "OW", "two site names"},
                          {"what", "colour", "colour"},
                          {"plot", "pdf", "must be"},
                          {"electrostatics", "none", "must be"},
                          {"molecules", "tip4p -1", "count"},
                          {"molecules", "tip4p, argon 3", "no count"},
                          {"energies", "e.csv", "give run"}}) {
    CAPTURE(one.name);
    CAPTURE(one.text);
    const auto request = filled<AnalysisRequest>({{"molecules", "tip4p 64"}, {one.name, one.text}});
    const std::string said = refusal([&] { analysis_input(request, "a.gro"); });
    CHECK(said.find(one.words) != said.npos);
  }
  CHECK(refusal([] {
          analysis_input(filled<AnalysisRequest>({}), "a.gro");
        }).find("not known; give either run water.toml or molecules") != std::string::npos);
}

TEST_CASE("bounds of the options of other jobs") {
  const Config config = default_config();
  CHECK(refusal([] {
          filled<MinimisationRequest>({{"max_force", "0 kJ/mol/nm"}}).settings();
        }).find("above 0 kJ/mol/nm") != std::string::npos);
  CHECK(refusal([] {
          filled<MinimisationRequest>({{"max_steps", "0"}}).settings();
        }).find("from 1 to") != std::string::npos);
  CHECK(refusal([&] {
          filled<TuneRequest>({{"runs", "1"}}).settings(config);
        }).find("from 2 to 1000") != std::string::npos);
  CHECK(refusal([&] {
          filled<TuneRequest>({{"step", "0 fs"}}).settings(config);
        }).find("longer than 0") != std::string::npos);
  CHECK(refusal([] {
          filled<VerificationRequest>({{"order", "13"}}).expected_order();
        }).find("from 1 to 12") != std::string::npos);
  CHECK(refusal([] {
          filled<BenchmarkRequest>({{"sizes", "512, 0"}}).settings(false, 1);
        }).find("sizes = \"0\"") != std::string::npos);
  CHECK(refusal([] {
          filled<ConversionRequest>({{"every", "0"}}).conversion("a.gro", "b.gro");
        }).find("from 1") != std::string::npos);
}

}  // namespace polhode
