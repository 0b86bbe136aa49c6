// SPDX-License-Identifier: MIT
#include "polhode/io/molecule_file.hpp"

#include <algorithm>
#include <cmath>

#include "errors.hpp"

using namespace polhode;

TEST_CASE("every model within the program reads, under its own name, neutral") {
  const auto names = molecule_names();
  CHECK(std::find(names.begin(), names.end(), "tip4p") != names.end());
  for (const std::string& name : names) {
    CAPTURE(name);
    const Molecule molecule = read_molecule(name);
    CHECK(molecule.name == name);
    CHECK(!molecule.source.empty());
    // Charges of a few significant digits sum with a rounding of 1e-16 each.
    CHECK(std::abs(molecule.charge()) < 1e-15 * static_cast<double>(molecule.sites.size()));
  }
}

TEST_CASE("the moments of TIP4P follow from its geometry") {
  const Molecule water = read_molecule("tip4p");
  // Geometry of [jorgensen1983]: J about the bisector 2 m_H x², about the H-H direction μ y² with μ
  // = 2 m_H m_O / M, and their sum normal to the plane, as for every planar body.
  const double half = 104.52 / 2 * std::acos(-1.0) / 180, m_H = 1.008, m_O = 15.9994;
  const double x = 0.09572 * std::sin(half), y = 0.09572 * std::cos(half);
  const double bisector = 2 * m_H * x * x, across = 2 * m_H * m_O / (2 * m_H + m_O) * y * y;
  // Coordinates of 16 digits and sums of a few terms: a dozen roundings.
  CHECK(water.J.x == doctest::Approx(across).epsilon(2e-15));
  CHECK(water.J.y == doctest::Approx(bisector).epsilon(2e-15));
  CHECK(water.J.z == doctest::Approx(across + bisector).epsilon(2e-15));
  CHECK(water.top == Top::asymmetric);
  CHECK(water.mass == doctest::Approx(18.0154).epsilon(1e-15));
}

namespace {

std::string file(const std::string& head, const std::string& site) {
  return head + "\n[[site]]\n" + site + "\n";
}
const std::string head = "name = \"x\"\nsource = \"key\"";  // two lines: the site begins at line 3
const std::string site =
    "name = \"A\"\nelement = \"Ar\"\nposition = \"0 0 0 nm\"\nmass = \"40 u\"\n";

void check_text(const std::string& text, std::initializer_list<const char*> parts) {
  check_error([&] { parse_molecule(text, "x.toml"); }, parts);
}

}  // namespace

TEST_CASE("a molecule file reads") {
  const Molecule atom =
      parse_molecule(file(head, site + "epsilon = \"120 K\"\nsigma = \"3.4 A\""), "x.toml");
  CHECK(atom.top == Top::atom);
  CHECK(atom.sites.front().sigma == doctest::Approx(0.34).epsilon(1e-15));
}

TEST_CASE("errors in molecule files name file, line and key") {
  check_error([] { read_molecule("tip4"); }, {"no molecule 'tip4'; did you mean 'tip4p'?"});
  check_error([] { read_molecule("./none.toml"); }, {"no readable file './none.toml'"});
  check_text(file(head, site + "sigmaa = \"0.3 nm\""),
             {"there is no key 'sigmaa'", "did you mean 'sigma'?", "x.toml:8, site[0].sigmaa"});
  check_text(file(head, site + "charge = 0.5"),
             {"charge = 0.5 has no unit", "\"0.5 e\"", "x.toml:8, site[0].charge"});
  check_text(file(head, site + "charge = \"0.5 nm\""), {"is a length; it must be a charge"});
  check_text(file(head, site + "sigma = \"-3 A\""), {"sigma = \"-3 A\" must be 0 or more"});
  check_text(file(head, site + "epsilon = \"3 K\""), {"sigma is 0", "x.toml"});
  check_text(file("name = \"x\"", site), {"no source", "write for example source", "x.toml"});
  check_text(file("source = \"x\"", site), {"no name"});
  check_text(file(head, "name = \"A\"\nmass = \"1 u\"\nelement = \"H\""),
             {"site 'A' has no position", "0 0.015 0 nm", "x.toml:3"});
  check_text(file(head, "name = \"A\"\nposition = \"0 0 0 nm\"\nmass = \"1 u\""),
             {"has mass but no element"});
  check_text(file(head, "name = \"A\"\nposition = \"0 0 0 nm\"\ncharge = \"1 e\""),
             {"has mass 0 u", "give a mass", "x.toml"});
  check_text(head, {"there is no site", "[[site]]"});
  check_text(file(head, "name = \"A"), {"not TOML", "x.toml:4"});
  check_text("name = \"x\"\nsource = 3", {"source = 3 must be a text in quotes", "x.toml:2"});
}
