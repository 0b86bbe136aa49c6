// SPDX-License-Identifier: MIT
#include "run/simulation/report/truncation_walk.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "polhode/integrate/scheme_text.hpp"
#include "polhode/io/settings/config.hpp"
#include "polhode/run/simulation/report/warnings.hpp"
#include "polhode/run/simulation/system/system.hpp"
#include "run/simulation/report/warning_rules.hpp"

using namespace polhode;

namespace {

/// The Bernoulli polynomial of degree n + 1 divided by (n + 1)!, continued periodically.
double periodic(int n, double x) {
  x -= std::floor(x);
  switch (n) {
    case 1:
      return (x * x - x + 1.0 / 6) / 2;
    case 2:
      return (x * x * x - 1.5 * x * x + 0.5 * x) / 6;
    default:
      return (std::pow(x, 4) - 2 * x * x * x + x * x - 1.0 / 30) / 24;
  }
}

std::string water(const std::string& forces, const std::string& scheme) {
  return "[system]\nmolecules = [{ model = \"tip4p\", count = 125 }]\ndensity = \"0.997 g/cm3\"\n"
         "temperature = \"298 K\"\n[forces]\ncutoff = \"0.75 nm\"\n" +
         forces + "\n[integrator]\nscheme = \"" + scheme +
         "\"\nstep = \"4 fs\"\n[run]\nlength = \"20 ps\"\n";
}

/// The warning at the start of a run, or nothing.
std::string warned(const std::string& forces, const std::string& scheme = "gier4-fd") {
  const Config config = parse_config(water(forces, scheme), "run.toml");
  const auto warning = rough_truncation(build_system(config), trajectory_settings(config));
  if (!warning) return "";
  CHECK(warning->kind == "truncation");
  CHECK(warning->value > warning->bound);
  return line_of(*warning);
}

const std::string reaction_field = "electrostatics = \"reaction-field\"\n";
const std::string site_switch = reaction_field + "truncation = \"site-switch\"\n";

}  // namespace

// Velocity Verlet has the variance of a Bernoulli polynomial, |B_{2n+2}|/(2n + 2)!; GIER4 has kicks
// of 1/3 and 2/3 half a step apart.
TEST_CASE("the error of one passage is that of periodic Bernoulli polynomials at the kicks") {
  const double exact[] = {1.0 / 30 / 24, 1.0 / 42 / 720, 1.0 / 30 / 40320};
  for (const int n : {1, 2, 3}) {
    CHECK(passage_error(scheme_of("velocity-verlet"), n) ==
          doctest::Approx(exact[n - 1]).epsilon(1e-12));
    constexpr int points = 1000;  // the polynomials are exact to 1/points² at least
    double sum = 0;
    for (int k = 0; k < points; ++k) {
      const double theta = (k + 0.5) / points;
      sum += std::pow(periodic(n, -theta) / 3 + periodic(n, 0.5 - theta) * 2 / 3, 2);
    }
    CHECK(passage_error(scheme_of("gier4"), n) == doctest::Approx(sum / points).epsilon(1e-4));
  }
}

TEST_CASE("the predicted walk grows with the step to the power 2n + 2, and with density and size") {
  const System system = build_system(parse_config(water(site_switch, "gier4"), "run.toml"));
  for (const int n : {1, 2, 3}) {
    ForceSettings forces = system.forces;
    forces.smoothness = n;
    const auto walk = [&](double volume, double T, double h) {
      return truncation_walk(system.topology, forces, volume, T, scheme_of("gier4"), h);
    };
    const double one = walk(4, 300, 0.004);
    CHECK(one > 0);
    CHECK(walk(4, 300, 0.002) * std::pow(2, 2 * n + 2) == doctest::Approx(one).epsilon(1e-12));
    CHECK(walk(8, 300, 0.004) * 2 == doctest::Approx(one).epsilon(1e-12));
    CHECK(walk(4, 1200, 0.004) / std::pow(2, 2 * n + 3) == doctest::Approx(one).epsilon(1e-12));
  }
}

TEST_CASE("a truncation that makes the energy walk is noted at the start, with what to do") {
  for (const std::string scheme : {"gier4-fd", "gier4", "hoa2"}) {
    const std::string text = warned(site_switch, scheme);
    for (const std::string part : {"2 continuous derivatives", "molecule-switch", "smoothness = 3"})
      CHECK(text.find(part) != std::string::npos);
  }
  CHECK(warned(site_switch + "smoothness = 1\n").find("1 continuous derivative;") !=
        std::string::npos);
  CHECK(warned(reaction_field).empty());
  CHECK(warned("electrostatics = \"pme\"\n").empty());
  CHECK(warned("electrostatics = \"damped-shifted-force\"\n").empty());
}
