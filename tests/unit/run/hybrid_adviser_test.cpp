// SPDX-License-Identifier: MIT
#include "run/canonical/hybrid_adviser.hpp"

#include <doctest/doctest.h>

#include <string>

#include "../errors.hpp"

using namespace polhode;

namespace {

HybridChoice choice(double step, double value, double error) {
  HybridChoice one{.step = step, .steps = 8};
  one.evaluations_per_sample = Estimate{value, error};
  return one;
}

/// 27 atoms of argon.
Config argon_run() {
  Config config;
  config.system.molecules = {{.model = "argon", .count = 27}};
  config.system.temperature = 150;
  config.forces.cutoff = 0.6;
  config.study.decorrelate = 0.5;
  return config;
}

}  // namespace

TEST_CASE("choices that differ by less than two standard errors are not distinguished") {
  HybridAdvice advice;
  advice.scheme = "hoa2";
  advice.finalists = {choice(0.004, 130, 10), choice(0.005, 100, 10), choice(0.006, 115, 5),
                      HybridChoice{.step = 0.007}, choice(0.003, 125, 20)};
  rank(advice);
  REQUIRE(advice.finalists.size() == 4);  // the one without a cost is left out
  CHECK(advice.finalists[0].step == 0.005);
  // 15 < 2·11, 25 < 2·22, 30 > 2·14.
  CHECK(advice.equal == std::vector<std::size_t>{1, 2});
  const std::string text = answer(advice);
  CHECK(text.find("8 steps of 5 fs") != std::string::npos);
  CHECK(
      text.find("not distinguishable in cost from this choice: 8 steps of 6 fs, 8 steps of 3 fs") !=
      std::string::npos);
  advice.pilots = {choice(0.005, 90, 40), choice(0.006, 120, 40)};
  CHECK(answer(advice).find("longer steps were not tried") == std::string::npos);
  advice.pilots.pop_back();
  CHECK(answer(advice).find("longer steps were not tried") != std::string::npos);
  advice.finalists.clear();
  rank(advice);
  CHECK(answer(advice).find("larger number of evaluations") != std::string::npos);
}

TEST_CASE("advice without a cost asks for more evaluations, which determine the length of runs") {
  CHECK(answer({}).find("give a larger number of evaluations") != std::string::npos);
}

TEST_CASE("schemes that are no palindromes are refused for hybrid Monte Carlo") {
  check_error([] { advise_hybrid(argon_run(), {.scheme = "B(1) A(1)"}); }, {"palindrome"});
}
