// SPDX-License-Identifier: MIT
// Options and keywords over a run file: what they set, what follows from them, and where errors
// are.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "io/settings/config_parts.hpp"
#include "io/settings/ensemble_names.hpp"
#include "polhode/base/error.hpp"
#include "polhode/io/settings/config.hpp"

namespace polhode {
namespace {

const std::string water = R"([system]
molecules = [{ model = "tip4p", count = 64 }]
density = "1 g/cm3"
[forces]
cutoff = "0.6 nm"
[integrator]
accuracy = "0.5 %"
)";

Overlay options(std::vector<Override> settings) {
  for (Override& one : settings) one.place = "--" + one.key.substr(one.key.find('.') + 1);
  return {.settings = std::move(settings)};
}

Config with(std::vector<Override> settings, const std::string& tables = "") {
  return parse_config(water + tables, "w.toml", options(std::move(settings)));
}

/// The message and the place of the error.
std::string refusal(std::vector<Override> settings, const std::string& tables = "") {
  try {
    with(std::move(settings), tables);
  } catch (const Error& e) {
    return std::string(e.what()) + " | " + e.where();
  }
  return "";
}

}  // namespace

TEST_CASE("options override the run file, and the last of two has precedence") {
  const Config c = with({{"forces.cutoff", {"0.5 nm"}, ""},
                         {"forces.cutoff", {"0.55 nm"}, ""},
                         {"system.seed", {"7"}, ""},
                         {"study.schemes", {"hoa2"}, ""},
                         {"study.steps", {"1 fs", "2 fs"}, ""}});
  CHECK(c.forces.cutoff == doctest::Approx(0.55));
  CHECK(c.system.seed == 7);
  REQUIRE(c.study.schemes.size() == 1);
  CHECK(c.study.schemes.front().text == "hoa2");
  CHECK(c.study.steps.size() == 2);
  CHECK(c.text == water);
}

TEST_CASE("values as in a run file keep their kind") {
  const Config c = with({{"system.seed", {}, "", "7"},
                         {"system.molecules", {}, "", R"([{ model = "tip4p", count = 27 }])"}});
  CHECK(c.system.seed == 7);
  CHECK(c.system.molecules.front().count == 27);
  CHECK(refusal({{"system.seed", {}, "", "\"7\""}}).find("whole number") != std::string::npos);
}

TEST_CASE("the place of an error is the option, of another setting the line of the file") {
  CHECK(refusal({{"integrator.step", {"-2 fs"}, ""}}).ends_with("| --step"));
  CHECK(refusal({{"system.seed", {"x"}, ""}}).ends_with("| --seed"));
  CHECK(refusal({{"system.molecules", {}, "", R"([{ model = "tip4q", count = 1 }])"}})
            .ends_with("| --molecules"));
  CHECK(refusal({{"integrator.step", {"2 fs"}, ""}}, "[run]\nlength = \"-1 ps\"\n")
            .ends_with("| w.toml:9, run.length"));
}

TEST_CASE("a setting replaces those that it contradicts") {
  CHECK_FALSE(with({{"integrator.step", {"2 fs"}, ""}}).integrator.accuracy);
  const Config boxed = with({{"system.box", {"1.3 nm"}, ""}});
  CHECK_FALSE(boxed.system.density);
  const std::string thermostat =
      "[thermostat]\nfriction = \"2 1/ps\"\nrotational_friction = \"5 1/ps\"\n";
  const Config same = with({{"thermostat.friction", {"3 1/ps"}, ""}}, thermostat);
  CHECK(std::get<Langevin>(*same.ensemble.thermostat).rotational_friction == doctest::Approx(3));
  const Config other = with({{"thermostat.type", {"rescaling"}, ""}}, thermostat);
  CHECK(type_name(*other.ensemble.thermostat) == "rescaling");
  CHECK_FALSE(with({{"thermostat.type", {"none"}, ""}}, thermostat).ensemble.thermostat);
  CHECK_FALSE(with({{"hybrid_monte_carlo.steps", {"0"}, ""}}, "[hybrid_monte_carlo]\nsteps = 4\n")
                  .ensemble.hybrid_monte_carlo);
}

TEST_CASE("a pressure selects a barostat and a thermostat, and says so") {
  const Config c = with({{"barostat.pressure", {"1 bar"}, ""}});
  CHECK(type_name(*c.ensemble.thermostat) == "langevin");
  CHECK(type_name(c.ensemble.barostat->type) == "cell-rescaling");
  CHECK(c.notes.size() == 2);
  CHECK_FALSE(with({{"barostat.pressure", {"1 bar"}, ""}}, "[hybrid_monte_carlo]\nsteps = 4\n")
                  .ensemble.thermostat);
  Overlay overlay = options({{"barostat.pressure", {"1 bar"}, ""}});
  overlay.pressure_selects_thermostat = false;
  CHECK(refusal({{"barostat.pressure", {"1 bar"}, ""}, {"barostat.type", {"none"}, ""}})
            .find("--pressure contradicts --type none") != std::string::npos);
  CHECK_FALSE(parse_config(water, "w.toml", overlay).ensemble.thermostat);
}

TEST_CASE("a parameter of a thermostat needs a thermostat") {
  CHECK(refusal({{"thermostat.friction", {"1 1/ps"}, ""}}) ==
        "friction is a setting of a thermostat, but this run has no thermostat; also select the "
        "thermostat langevin | --friction");
  CHECK(refusal({{"thermostat.time_constant", {"1 ps"}, ""}}).find("rescaling") !=
        std::string::npos);
}

TEST_CASE("the text of a run file with an overlay is a run file of the same settings") {
  const Overlay overlay = options({{"barostat.pressure", {"1 bar"}, ""},
                                   {"forces.precision", {"mixed"}, ""},
                                   {"system.seed", {}, "", "7"}});
  const std::string text = overlaid_text(water, "w.toml", overlay);
  const Config c = parse_config(text, "w.toml");
  CHECK(c.forces.precision == Precision::mixed);
  CHECK(c.system.seed == 7);
  CHECK(c.ensemble.thermostat);
  CHECK(overlaid_text(water, "w.toml", {}) == water);
}

}  // namespace polhode
