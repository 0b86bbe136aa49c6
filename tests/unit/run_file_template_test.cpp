// SPDX-License-Identifier: MIT
#include "polhode/io/run_file_template.hpp"

#include <doctest/doctest.h>

#include <string>

#include "polhode/io/config.hpp"

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

}  // namespace polhode
