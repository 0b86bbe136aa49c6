// SPDX-License-Identifier: MIT
#include "polhode/io/topology/molecule_file.hpp"

#include <algorithm>
#include <cmath>

#include "../errors.hpp"
#include "io/settings/quantity.hpp"
#include "io/topology/potential_table.hpp"

using namespace polhode;

TEST_CASE("every built-in model can be read, has the name of its file and an integer charge") {
  const auto names = molecule_names();
  CHECK(std::find(names.begin(), names.end(), "tip4p") != names.end());
  for (const std::string& name : names) {
    CAPTURE(name);
    const Molecule molecule = read_molecule(name);
    CHECK(molecule.name == name);
    CHECK(!molecule.source.empty());
    // Charges of a few significant digits sum with a rounding of 1e-16 each.
    const double whole = std::round(molecule.charge());
    CHECK(std::abs(molecule.charge() - whole) < 1e-15 * static_cast<double>(molecule.sites.size()));
    CHECK((whole == 0 || molecule.top == Top::atom));  // the ions
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

// From the papers of the models, with as many digits as they give; for TIP5P and the OPC models,
// too.
TEST_CASE("dipole moments of the models of water are the published ones") {
  const struct {
    const char* name;
    double dipole, half_digit;  // [D]
  } published[] = {{"spc", 2.27, 0.005},        {"spce", 2.35, 0.005},  {"tip3p", 2.35, 0.005},
                   {"tip4p", 2.18, 0.005},      {"tip5p", 2.29, 0.005}, {"tip4p-2005", 2.305, 5e-4},
                   {"tip4p-ew", 2.32, 0.005},   {"opc", 2.48, 0.005},   {"opc3", 2.43, 0.005},
                   {"tip4p-ice", 2.426, 0.0005}};
  for (const auto& water : published) {
    CAPTURE(water.name);
    const double dipole = read_molecule(water.name).dipole() / unit("D", Dimension::dipole);
    CHECK(std::abs(dipole - water.dipole) <= water.half_digit);
  }
}

// Atomic weights; what symmetry makes of the moments; moments by hand from bond lengths and angles.
TEST_CASE("masses, tops and moments of the models are those of their geometry") {
  const struct {
    const char* name;
    double mass;
    Top top;
  } models[] = {{"neon", 20.1797, Top::atom},        {"krypton", 83.798, Top::atom},
                {"xenon", 131.293, Top::atom},       {"na-spce", 22.98977, Top::atom},
                {"k-tip3p", 39.0983, Top::atom},     {"cl-tip4p-ew", 35.453, Top::atom},
                {"o2", 31.9988, Top::linear},        {"n2", 28.0134, Top::linear},
                {"co2", 44.0098, Top::linear},       {"co2-epm2", 44.0098, Top::linear},
                {"ch4", 16.043, Top::spherical},     {"ccl4", 153.823, Top::spherical},
                {"nh3", 17.0307, Top::symmetric},    {"benzene", 78.114, Top::symmetric},
                {"tip5p", 18.0154, Top::asymmetric}, {"methylhydrazine", 46.0724, Top::asymmetric}};
  for (const auto& model : models) {
    CAPTURE(model.name);
    const Molecule m = read_molecule(model.name);
    CHECK(m.mass == doctest::Approx(model.mass).epsilon(1e-12));
    CHECK(m.top == model.top);
  }
  CHECK(read_molecule("o2").J.z == doctest::Approx(31.9988 / 4 * 0.121 * 0.121).epsilon(1e-12));
  // A tetrahedron: 8/3 m r², to which the centre does not contribute.
  CHECK(read_molecule("ccl4").J.x ==
        doctest::Approx(8.0 / 3 * 35.453 * 0.176 * 0.176).epsilon(1e-12));
  // About the axis 3 m_H ρ², with ρ of three hydrogens.
  CHECK(read_molecule("nh3").J.z ==
        doctest::Approx(3 * 1.008 * 0.0934689 * 0.0934689).epsilon(1e-12));
}

// Lone pairs and hydrogens of TIP5P: two perpendicular V shapes, 0.07 nm and 0.09572 nm long.
TEST_CASE("the sites of TIP5P are at the published positions") {
  const Molecule water = read_molecule("tip5p");
  REQUIRE(water.sites.size() == 5);
  const auto from_oxygen = [&](std::size_t k) { return water.sites[k].r - water.sites[0].r; };
  const auto angle = [&](std::size_t i, std::size_t k) {
    const Vec3<double> a = from_oxygen(i), b = from_oxygen(k);
    return std::acos(dot(a, b) / (norm(a) * norm(b))) * 180 / std::acos(-1.0);
  };
  CHECK(norm(from_oxygen(3)) == doctest::Approx(0.07).epsilon(1e-12));
  CHECK(norm(from_oxygen(4)) == doctest::Approx(0.07).epsilon(1e-12));
  CHECK(angle(1, 2) == doctest::Approx(104.52).epsilon(1e-12));
  CHECK(angle(3, 4) == doctest::Approx(109.47).epsilon(1e-12));
  // The two V shapes are perpendicular, so all four angles between them have the same cosine,
  // −cos(104.52°/2) cos(109.47°/2).
  for (const std::size_t h : {1u, 2u})
    for (const std::size_t l : {3u, 4u})
      CHECK(std::cos(angle(h, l) * std::acos(-1.0) / 180) ==
            doctest::Approx(-std::cos(52.26 * std::acos(-1.0) / 180) *
                            std::cos(54.735 * std::acos(-1.0) / 180))
                .epsilon(1e-12));
}

// No two moments are equal, and the charges and masses lie in no plane: the product of the three
// edges from one site to three others has the volume of a true tetrahedron.
TEST_CASE("methylhydrazine has no symmetry") {
  const Molecule m = read_molecule("methylhydrazine");
  CHECK(m.J.y - m.J.x > 0.1 * m.J.z);
  CHECK(m.J.z - m.J.y > 0.01 * m.J.z);
  const Vec3<double> o = m.sites[2].r;
  CHECK(std::abs(dot(m.sites[0].r - o, cross(m.sites[3].r - o, m.sites[4].r - o))) > 1e-4);
}

namespace {

std::string file(const std::string& head, const std::string& site) {
  return head + "\n[[site]]\n" + site + "\n";
}
const std::string head = "name = \"x\"\nsource = \"key\"";  // two lines: the site begins at line 3
const std::string site =
    "name = \"A\"\nelement = \"Ar\"\nposition = \"0 0 0 nm\"\nmass = \"40 u\"\n";

void check_molecule(const std::string& text, std::initializer_list<const char*> parts) {
  check_error([&] { parse_molecule(text, "x.toml"); }, parts);
}

}  // namespace

TEST_CASE("a molecule file is read") {
  const Molecule atom =
      parse_molecule(file(head, site + "epsilon = \"120 K\"\nsigma = \"3.4 A\""), "x.toml");
  CHECK(atom.top == Top::atom);
  CHECK(!atom.mixing);
  const std::string rule = head + "\nmixing = \"geometric\"";
  CHECK(parse_molecule(file(rule, site), "x.toml").mixing == MixingRule::geometric);
  check_molecule(file(head + "\nmixing = \"arithmetic\"", site),
                 {"must be one of: lorentz-berthelot, geometric", "x.toml:3"});
  CHECK(atom.sites.front().sigma == doctest::Approx(0.34).epsilon(1e-15));
}

TEST_CASE("a site has the short-range law that its file names") {
  const auto law = [](const std::string& more) {
    return parse_molecule(file(head, site + more), "x.toml").sites.front().law;
  };
  const std::string sizes = "epsilon = \"120 K\"\nsigma = \"3.4 A\"\n";
  CHECK(law(sizes) == ShortRangeLaw(LennardJonesLaw{}));
  CHECK(law(sizes + "law = \"lennard-jones\"") == ShortRangeLaw(LennardJonesLaw{}));
  CHECK(law(sizes + "law = \"mie\"\nrepulsive_exponent = 14.5\nattractive_exponent = 6") ==
        ShortRangeLaw(MieLaw{14.5, 6}));
  const auto buckingham = std::get<BuckinghamLaw>(
      law("law = \"buckingham\"\nA = \"1e5 kcal/mol\"\nB = \"3 1/A\"\nC = \"500 kcal/mol A6\""));
  CHECK(buckingham.A == doctest::Approx(4.184e5).epsilon(1e-15));
  CHECK(buckingham.B == 30);
  CHECK(buckingham.C == doctest::Approx(500 * 4.184e-6).epsilon(1e-15));
  const Molecule argon = read_molecule("argon-ab-initio");
  const auto& table = *std::get<TabulatedLaw>(argon.sites.front().law).table;
  CHECK(table.name() == "molecules/argon-ab-initio.txt");
  CHECK(table.first() == 0.2);
  CHECK(table.last() == doctest::Approx(1.6).epsilon(1e-14));

  check_molecule(file(head, site + "law = \"exp6\""),
                 {"must be one of: lennard-jones, mie, buckingham, tabulated", "site[0].law"});
  check_molecule(file(head, site + sizes + "law = \"mie\""),
                 {"no repulsive_exponent; write for example repulsive_exponent = 14"});
  check_molecule(file(head, site + sizes + "repulsive_exponent = 14"),
                 {"there is no key 'repulsive_exponent'"});
  check_molecule(file(head, site + "law = \"buckingham\"\nA = \"1 kJ/mol\"\nB = \"1 1/nm\""),
                 {"a site has no C; write for example C = \"6e-3 kJ/mol nm6\""});
  check_molecule(file(head, site + "law = \"buckingham\"\nA = \"1 kJ/mol\"\nB = \"9 1/nm\"\n"
                                   "C = \"1 kJ/mol nm6\""),
                 {"molecule 'x', site 'A'", "attract each other at all distances"});
  check_molecule(file(head, site + "law = \"tabulated\""), {"no table; write for example table"});
  check_molecule(file(head, site + "law = \"tabulated\"\ntable = \"gone.txt\""),
                 {"no readable file 'gone.txt'"});
}

TEST_CASE("errors in potential tables name file, line and bound") {
  const auto refused = [](const std::string& text, std::initializer_list<const char*> parts) {
    check_error([&] { parse_potential_table(text, "u.txt"); }, parts);
  };
  const std::string rows = "# r u f\n0.3 3 10\n0.4 2 10 # a comment\n\n0.5 1 10\n0.6 0 10\n";
  const auto table = parse_potential_table(rows, "u.txt").table;
  CHECK(table->intervals() == 3);
  CHECK(table->spacing() == doctest::Approx(0.1).epsilon(1e-14));
  refused("0.3 3 10\n0.4 2 10\n", {"the table has 2 lines; a spline needs at least 4", "u.txt"});
  refused(replaced(rows, "0.5 1 10", "0.5 1"), {"2 fields; it must have 3", "u.txt:5"});
  refused(replaced(rows, "0.5 1", "0.5 nan"), {"the energy is nan", "u.txt:5"});
  refused(replaced(rows, "0.5 1", "0.51 1"),
          {"distance 3 is 0.51 nm instead of 0.5 nm; the spline needs equal intervals"});
  refused(replaced(rows, "0.3 3", "-0.1 3"), {"from -0.1 to 0.6 nm; distances must be above 0"});
  refused(replaced(rows, "0.4 2 10", "0.4 2 20"), {"the force at r = 0.4 nm is 20", "1 %"});
}

TEST_CASE("errors in molecule files name file, line and key") {
  check_error([] { read_molecule("tip4"); }, {"no molecule 'tip4'; did you mean 'tip4p'?"});
  check_error([] { read_molecule("./none.toml"); }, {"no readable file './none.toml'"});
  check_molecule(file(head, site + "sigmaa = \"0.3 nm\""),
                 {"there is no key 'sigmaa'", "did you mean 'sigma'?", "x.toml:8, site[0].sigmaa"});
  check_molecule(file(head, site + "charge = 0.5"),
                 {"charge = 0.5 has no unit", "\"0.5 e\"", "x.toml:8, site[0].charge"});
  check_molecule(file(head, site + "charge = \"0.5 nm\""), {"is a length; it must be a charge"});
  check_molecule(file(head, site + "sigma = \"-3 A\""), {"sigma = \"-3 A\" must be 0 or more"});
  check_molecule(file(head, site + "epsilon = \"3 K\""),
                 {"no effect without sigma", "x.toml:8, site[0].epsilon"});
  check_molecule(file(head, site + "epsilon = \"-3 K\""), {"epsilon = \"-3 K\" must be 0 or more"});
  check_molecule(
      file(head + "\nmoments = \"1 1 3 nm\"", site),  // they follow from the sites
      {"there is no key 'moments'", "there are: name, description, source, mixing, site"});
  check_molecule(file("name = \"x\"", site), {"no source", "write for example source", "x.toml"});
  check_molecule(file("source = \"x\"", site), {"no name"});
  check_molecule(file(head, "name = \"A\"\nmass = \"1 u\"\nelement = \"H\""),
                 {"site 'A' has no position", "0 0.015 0 nm", "x.toml:3"});
  check_molecule(file(head, "name = \"A\"\nposition = \"0 0 0 nm\"\nmass = \"1 u\""),
                 {"has mass but no element"});
  check_molecule(file(head, "name = \"A\"\nposition = \"0 0 0 nm\"\ncharge = \"1 e\""),
                 {"has mass 0 u", "give at least one site a mass", "x.toml"});
  check_molecule(head, {"the molecule has no site", "[[site]]"});
  check_molecule(file(head, "name = \"A"), {"not TOML", "no end on this line", "x.toml:4"});
  check_molecule(file(head, site + "sigma = \"3 A\""),
                 {"no effect without epsilon", "site[0].sigma"});
  check_molecule(file(head, site + "[[site]]\n" + site), {"the same position"});
  check_molecule(file(head, replaced(site, "element = \"", "element = \"X")),
                 {"not a chemical element", "leave it out"});
  check_molecule("name = \"x\"\nsource = 3", {"source = 3 must be a text in quotes", "x.toml:2"});
}
