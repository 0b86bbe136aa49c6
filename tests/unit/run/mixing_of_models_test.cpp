// SPDX-License-Identifier: MIT
// The mixing rule of a system of molecule models.
#include <doctest/doctest.h>

#include <string>

#include "../errors.hpp"
#include "polhode/io/settings/config.hpp"
#include "polhode/run/simulation/system/system.hpp"

using namespace polhode;

namespace {

MixingRule rule_of(const std::string& molecules, const std::string& forces = "") {
  const std::string text =
      "[system]\nmolecules = [" + molecules +
      "]\nbox = \"4 nm\"\ntemperature = \"300 K\"\n[forces]\ncutoff = \"1 nm\"\n" + forces;
  return build_system(parse_config(text, "x.toml")).forces.mixing.rule;
}

const std::string ch4 = R"({ model = "ch4", count = 8 })",
                  ccl4 = R"({ model = "ccl4", count = 8 })",
                  argon = R"({ model = "argon", count = 8 })";

}  // namespace

TEST_CASE("the mixing rule of molecule files applies unless the run file gives another") {
  CHECK(rule_of(argon) == MixingRule::lorentz_berthelot);
  CHECK(rule_of(ch4) == MixingRule::geometric);
  CHECK(rule_of(ch4 + ", " + ccl4) == MixingRule::geometric);
  CHECK(rule_of(ch4, "mixing = \"lorentz-berthelot\"") == MixingRule::lorentz_berthelot);
  CHECK(rule_of(ch4 + ", " + argon, "mixing = \"geometric\"") == MixingRule::geometric);
  for (const std::string& both : {ch4 + ", " + argon, argon + ", " + ch4})
    check_error([&] { rule_of(both); },
                {"the files of the models 'ch4' and 'argon' do not state the same mixing rule",
                 "write mixing = \"geometric\"", "x.toml, forces.mixing"});
}
