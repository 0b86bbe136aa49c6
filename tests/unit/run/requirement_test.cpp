// SPDX-License-Identifier: MIT
// What is required of a run, as text.
#include "polhode/io/settings/requirement.hpp"

#include <doctest/doctest.h>

#include <string>
#include <utility>
#include <vector>

#include "../errors.hpp"
#include "io/settings/required_bias.hpp"
#include "polhode/run/adviser/criterion.hpp"

using namespace polhode;

TEST_CASE("requirements: texts and their bounds") {
  const std::vector<std::pair<std::string, Requirement>> all{
      {"0.1 K", {RequiredOf::temperature_difference, 0.1}},
      {"energy 0.01 kJ/mol", {RequiredOf::energy, 0.01}},
      {"pressure 4 bar", {RequiredOf::pressure, 4 * 0.0602214076}},
      {"density 0.02 %", {RequiredOf::density, 2e-4}}};
  for (const auto& [text, expected] : all) {
    CAPTURE(text);
    CHECK(is_of_bias(text));
    const Requirement found = required_bias(text, "--bias");
    CHECK(found.of == expected.of);
    CHECK(found.bound == doctest::Approx(expected.bound).epsilon(1e-14));
    CHECK(text_of(found) == text);
  }
  CHECK(required_bias("energy 1 kcal/mol", "--bias").bound == doctest::Approx(4.184));
  CHECK_FALSE(is_of_bias("0.5 %"));
  CHECK_FALSE(is_of_bias("0.5"));
  CHECK(text_of({RequiredOf::ratio, 0.005}) == "0.5 %");
}

TEST_CASE("requirements: what is refused") {
  const auto refused = [](const std::string& text, std::initializer_list<const char*> words) {
    check_error([&] { required_bias(text, "--bias"); }, words);
  };
  refused("0 K", {"--bias", "above 0", "0.1 K"});
  refused("-1 K", {"above 0"});
  refused("energy", {"no bound", "energy 0.01 kJ/mol"});
  refused("energy 1 bar", {"--bias", "bar"});
  refused("pressure 4", {"no unit", "pressure 4 bar"});
  refused("volume 1 %", {"volume"});
}

TEST_CASE("requirements: a density is bounded by the pressure that would change it") {
  EnsembleSettings ensemble;
  const Requirement density{RequiredOf::density, 2e-4};
  check_error([&] { criterion_of(density, ensemble); }, {"compressibility", "[barostat]"});
  ensemble.thermostat = Rescaling{};
  ensemble.barostat = BarostatSettings{.compressibility = 5e-4};
  CHECK(criterion_of(density, ensemble).quality == Quality::pressure_bias);
  CHECK(criterion_of(density, ensemble).bound == doctest::Approx(0.4));
}

TEST_CASE("requirements: biases are bounded only in ensembles in which they are known") {
  const Requirement energy{RequiredOf::energy, 0.01}, ratio{RequiredOf::ratio, 0.005};
  const auto refused = [&](const EnsembleSettings& ensemble,
                           std::initializer_list<const char*> words) {
    check_error([&] { criterion_of(energy, ensemble); }, words);
    CHECK(criterion_of(ratio, ensemble).quality == Quality::ratio);
  };
  EnsembleSettings ensemble;
  CHECK(criterion_of(energy, ensemble).quality == Quality::energy_bias);
  ensemble.thermostat = ThermostatSettings{};
  refused(ensemble, {"rescaling", "[thermostat]", "not known"});
  ensemble.thermostat = SeparateRescaling{};
  refused(ensemble, {"rescaling", "not known"});
  ensemble.thermostat = Rescaling{};
  CHECK(criterion_of(energy, ensemble).quality == Quality::energy_bias);
  ensemble.barostat = BarostatSettings{.edges = {{true, true, false}, {false, false, true}}};
  refused(ensemble, {"edges = [\"xyz\"]"});
  refused({.temperature = 300, .hybrid_monte_carlo = HybridMonteCarloSettings{}},
          {"hybrid Monte Carlo has no time-step bias"});
}
