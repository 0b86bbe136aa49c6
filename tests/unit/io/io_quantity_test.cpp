// SPDX-License-Identifier: MIT
#include "io/settings/quantity.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "../errors.hpp"
#include "base/suggest.hpp"
#include "polhode/base/units.hpp"

using namespace polhode;

// A value and its unit are each rounded once and multiplied with one rounding: 3 half units of
// relative rounding, 1.1e-16 each.
static bool same(double a, double b) { return std::abs(a - b) <= 3 * 1.2e-16 * std::abs(b); }

TEST_CASE("quantities become internal units") {
  CHECK(same(quantity("2 fs", Dimension::time, "step"), 0.002));
  CHECK(same(quantity("15ps", Dimension::time, "length"), 15));
  CHECK(same(quantity("1.5 ns", Dimension::time, "length"), 1500));
  CHECK(same(quantity(" +1.0  nm ", Dimension::length, "cutoff"), 1));
  CHECK(same(quantity("0.85 A", Dimension::length, "r"), 0.085));
  CHECK(same(quantity("0.85 Å", Dimension::length, "r"), 0.085));
  CHECK(same(quantity("95.72 pm", Dimension::length, "r"), 0.09572));
  CHECK(same(quantity("0.1550 kcal/mol", Dimension::energy, "epsilon"), 0.64852));
  CHECK(same(quantity("-2 kJ/mol", Dimension::energy, "epsilon"), -2));
  CHECK(same(quantity("36.4 K", Dimension::energy, "epsilon"), 36.4 * units::boltzmann));
  CHECK(same(quantity("297 K", Dimension::temperature, "temperature"), 297));
  CHECK(same(quantity("-1.04e", Dimension::charge, "charge"), -1.04));
  CHECK(same(quantity("15.9994 g/mol", Dimension::mass, "mass"), 15.9994));
  CHECK(same(quantity("1.008 u", Dimension::mass, "mass"), 1.008));
  CHECK(same(quantity("0.5%", Dimension::fraction, "accuracy"), 0.005));
  CHECK(same(quantity("1 g/cm3", Dimension::density, "density"), 602.214076));
  CHECK(same(quantity("997 kg/m3", Dimension::density, "density"), 0.997 * 602.214076));
  // The charges of TIP4P give 2.177 D [jorgensen1983]: 2 * 0.52 e * (0.0586 - 0.015) nm.
  CHECK(1.04 * 0.043588227661829494 / unit("D", Dimension::dipole) ==
        doctest::Approx(2.177).epsilon(0.0005 / 2.177));
  const Vec3<double> r = vector_quantity("0 0.15 -1 A", Dimension::length, "position");
  CHECK(r.x == 0);
  CHECK(same(r.y, 0.015));
  CHECK(same(r.z, -0.1));
}

TEST_CASE("a quantity without a unit is refused with an example") {
  check_error([] { quantity("2", Dimension::time, "step"); },
              {R"(step = "2" has no unit; write for example "2 fs")"});
  check_error([] { quantity("15", Dimension::time, "length", "15 ps"); }, {R"("15 ps")"});
  check_error([] { vector_quantity("0 1 2", Dimension::length, "position"); },
              {R"(has no unit; write for example "0 1 2 nm")"});
  // units of two words, units that begin with a digit, and fractions in percent
  check_error([] { quantity("0.855", Dimension::viscosity, "--viscosity"); }, {R"("0.855 mPa s")"});
  check_error([] { quantity("3", Dimension::inverse_length, "damping"); }, {R"("3 1/nm")"});
  check_error([] { quantity("0.005", Dimension::fraction, "accuracy"); },
              {R"(write "0.005 %", or "0.5 %" if the number is a fraction of 1)"});
  check_error([] { quantity("1e308", Dimension::fraction, "accuracy"); }, {R"("1e308 %")"});
}

TEST_CASE("the first letter of a sentence becomes small, those of a word in capitals stay") {
  CHECK(uncapitalized("The following argument was not expected") ==
        "the following argument was not expected");
  CHECK(uncapitalized("SCHEME is required") == "SCHEME is required");
  CHECK(uncapitalized("A subcommand is required") == "a subcommand is required");
  CHECK(uncapitalized("--step: 1 required") == "--step: 1 required");
  CHECK(uncapitalized("") == "");
}

TEST_CASE("a quantity of the wrong dimension is refused with the right one") {
  check_error(
      [] { quantity("2 fs", Dimension::length, "cutoff"); },
      {R"(cutoff = "2 fs" is a time; it must be a length, in one of the units: nm, A)", "1 nm"});
  check_error([] { quantity("2 kcal/mol", Dimension::temperature, "temperature"); },
              {"is an energy; it must be a temperature, in one of the units: K", "297 K"});
  check_error([] { quantity("2 fss", Dimension::time, "step"); },
              {"there is no unit 'fss' of time", "did you mean 'fs'?", "fs, ps, ns, us"});
}

TEST_CASE("numbers are finite and whole") {
  check_error([] { quantity("inf K", Dimension::temperature, "t"); }, {"finite", "297 K"});
  check_error([] { quantity("nan K", Dimension::temperature, "t"); }, {"finite"});
  check_error([] { quantity("1e999 K", Dimension::temperature, "t"); }, {"finite"});
  check_error([] { quantity("fs", Dimension::time, "step"); }, {"has no number"});
  check_error([] { quantity("", Dimension::time, "step"); }, {"has no number"});
  check_error([] { quantity("0,85 nm", Dimension::length, "switch"); }, {"comma", "point"});
  check_error([] { vector_quantity("0 1 nm", Dimension::length, "position"); },
              {"has no number", "0 0.015 0 nm"});
  check_error([] { unit("parsec", Dimension::length); }, {"no unit 'parsec' of length", "nm"});
}

TEST_CASE("the nearest name is suggested, but none if all are too different") {
  CHECK(edit_distance("gier4", "giere4") == 1);
  CHECK(edit_distance("hoa2", "hao2") == 1);  // a swap of neighbours is one edit
  CHECK(edit_distance("", "abc") == 3);
  const std::vector<std::string> names = {"velocity-verlet", "hoa2", "gier4"};
  CHECK(did_you_mean("giere4", names) == "; did you mean 'gier4'?");
  CHECK(did_you_mean("velocityverlet", names) == "; did you mean 'velocity-verlet'?");
  CHECK(did_you_mean("leapfrog", names) == "");
  const std::vector<std::string> kelvin = {"K"};
  CHECK(did_you_mean("C", kelvin) == "");  // 25 C are not 25 K
  CHECK(did_you_mean("k", kelvin) == "; did you mean 'K'?");
  CHECK(did_you_mean("VELOCITY_VERLET", names) == "; did you mean 'velocity-verlet'?");
  CHECK(same_letters("SPC/E", "spce"));
  CHECK(!same_letters("/", "-"));
}
