// SPDX-License-Identifier: MIT
// The accuracy guarantee of a run that is resumed.
#include "polhode/run/adviser/guarantee.hpp"

#include <doctest/doctest.h>

#include "../errors.hpp"
#include "../folder.hpp"

using namespace polhode;

namespace {

Config with_accuracy(double accuracy, const std::string& scheme = "") {
  Config config;
  config.integrator.accuracy = Requirement{RequiredOf::ratio, accuracy};
  if (scheme.empty()) return config;
  config.integrator.scheme = scheme;
  config.given["integrator.scheme"] = {scheme, "water.toml"};
  return config;
}

}  // namespace

TEST_CASE("a run is resumed with the scheme and step that were chosen for its accuracy") {
  const Folder folder;
  const std::string file = folder / "guarantee.json";
  IntegratorSettings chosen = with_accuracy(0.01, "hoa2").integrator;
  chosen.step = 0.0035;
  write_guarantee(file, {{RequiredOf::ratio, 0.01}, 20, {0.005, 0.0001}}, chosen);

  // Whether the scheme is not given, or given by its name or its stages.
  for (const char* scheme : {"", "hoa2", "B(eta) A(1/2) B(1 - 2*eta) A(1/2) B(eta)"}) {
    CAPTURE(scheme);
    std::string text = scheme;
    if (text.starts_with("B")) text = "eta = 0.1931833275037836; " + text;
    Config resumed = with_accuracy(0.01, text);
    CHECK(read_guarantee(file, resumed).length == 20);
    CHECK(resumed.integrator.scheme == "hoa2");
    CHECK(resumed.integrator.step == 0.0035);
  }
}

TEST_CASE("a run is not resumed with another accuracy or scheme than its step was chosen for") {
  const Folder folder;
  const std::string file = folder / "guarantee.json";
  write_guarantee(file, {{RequiredOf::ratio, 0.01}, 20, {0.005, 0.0001}},
                  with_accuracy(0.01, "hoa2").integrator);

  Config stricter = with_accuracy(0.001);
  check_error(
      [&] { read_guarantee(file, stricter); },
      {"accuracy = \"1 %\"", "now \"0.1 %\"", "guarantee.json", "restore the earlier value"});
  Config other = with_accuracy(0.01, "gier4");
  check_error([&] { read_guarantee(file, other); }, {"scheme = ", "is now", "start over"});
}
