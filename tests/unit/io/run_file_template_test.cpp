// SPDX-License-Identifier: MIT
#include "io/settings/run_file_template.hpp"

#include <doctest/doctest.h>

#include <string>

#include "../errors.hpp"
#include "polhode/io/settings/config.hpp"

namespace polhode {

// Those of GROMACS and LAMMPS name files, which tests/cli/first_steps.py provides.
TEST_CASE("run files to start from are read as they are") {
  for (const char* kind : {"water", "nvt", "npt", "mixture"}) {
    CAPTURE(kind);
    const std::string text(run_file_template(kind));
    const Config config = parse_config(text, "start.toml");
    CHECK(config.forces.electrostatics == Electrostatics::pme);
    CHECK(config.integrator.step == doctest::Approx(0.004));
    CHECK(config.ensemble.barostat.has_value() == (std::string(kind) == "npt"));
    CHECK(config.ensemble.thermostat.has_value() == std::string(kind).starts_with("n"));
  }
}

TEST_CASE("a kind at constant energy gets the tables of another ensemble") {
  for (const char* kind : {"water", "mixture"})
    for (const char* ensemble : {"nve", "nvt", "npt"}) {
      CAPTURE(kind);
      CAPTURE(ensemble);
      const Config config = parse_config(run_file_template(kind, ensemble), "start.toml");
      CHECK(config.ensemble.thermostat.has_value() == (std::string(ensemble) != "nve"));
      CHECK(config.ensemble.barostat.has_value() == (std::string(ensemble) == "npt"));
      CHECK(config.output.prefix == kind);
    }
  for (const char* kind : {"gromacs", "lammps"}) {
    const std::string text = run_file_template(kind, "npt");
    CHECK(text.find("[barostat]") < text.find("[output]"));
    CHECK(text.find("at constant temperature and pressure") != std::string::npos);
  }
  check_error([] { run_file_template("nvt", "npt"); }, {"'nvt'", "kind 'npt'"});
  check_error([] { run_file_template("water", "nph"); }, {"'nph'", "npt"});
}

}  // namespace polhode
