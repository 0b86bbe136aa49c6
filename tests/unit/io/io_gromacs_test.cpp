// SPDX-License-Identifier: MIT
#include "polhode/io/topology/gromacs.hpp"

#include <fmt/core.h>

#include <cmath>

#include "../errors.hpp"
#include "polhode/io/coordinates/frame_file.hpp"
#include "polhode/io/topology/molecule_file.hpp"
#include "polhode/io/topology/topology_file.hpp"
#include "polhode/math/rotation.hpp"
#include "skip.hpp"

using namespace polhode;

namespace {

const std::string spce =
    "[ defaults ]\n"
    "1 2\n"
    "[ atomtypes ]\n"
    "OW 8 15.9994 0 A 0.316557 0.650629\n"
    "HW 1 1.008 0 A 0 0\n"
    "NA 11 22.99 1 A 0.2584 0.4184\n"
    "[ moleculetype ]\n"
    "SOL 2\n"
    "[ atoms ]\n"
    "1 OW 1 SOL OW 1 -0.8476 15.9994\n"
    "2 HW 1 SOL HW1 1 0.4238 1.008\n"
    "3 HW 1 SOL HW2 1 0.4238 1.008\n"
    "[ settles ]\n"
    "1 1 0.1 0.16330\n"
    "[ moleculetype ]\n"
    "NA 1\n"
    "[ atoms ]\n"
    "1 NA 1 NA NA 1\n"
    "[ system ]\n"
    "a box of water\n"
    "[ molecules ]\n"
    "SOL 3\n";

const IncludeLoader nothing = [](const std::string&, const std::string&) {
  return std::optional<LoadedText>{};
};

GromacsTopology parsed(const std::string& text, const IncludeLoader& loader = nothing,
                       const std::vector<std::string>& defines = {}) {
  return parse_gromacs(text, "topol.top", loader, defines);
}

void refused(const std::string& text, std::initializer_list<const char*> parts,
             const IncludeLoader& loader = nothing) {
  check_error([&] { rigid_topology(parsed(text, loader), {}, nullptr); }, parts);
}

// Molecules of these shapes, rotated and far from each other.
Frame start_of(const std::vector<Shape>& shapes) {
  Frame frame;
  frame.source = "conf.gro";
  frame.box = Box{{9, 9, 9}};
  for (const Shape& shape : shapes) {
    const auto k = static_cast<double>(frame.atoms.size());
    const auto turn = rotation_quaternion(Vec3<double>{0.3 * k, 1 - k, 0.2});
    for (std::size_t i = 0; i < shape.size(); ++i) {
      const char* water = i == 0 ? "OW" : "HW";
      frame.kinds.push_back({"M", shape.size() == 3 ? water : "C", ""});
      frame.atoms.push_back({static_cast<std::uint32_t>(frame.kinds.size() - 1),
                             0,
                             Vec3<double>{0.1 * k + 1, 2, 3} + to_lab(turn, shape[i]),
                             {}});
    }
  }
  return frame;
}

// Of the first molecule, in its principal frame.
Shape shape_of(const RigidTopology& rigid) {
  Shape shape;
  for (const Site& site : rigid.topology.parts[0].molecule.sites) shape.push_back(site.r);
  return shape;
}

// One included file of that text, under any name.
IncludeLoader includes(const std::string& text) {
  return [text](const std::string& name, const std::string&) { return LoadedText{name, text}; };
}

}  // namespace

TEST_CASE("a topology with SETTLE water gives the built-in water") {
  const GromacsTopology gromacs = parsed(spce);
  CHECK(gromacs.title == "a box of water");
  const RigidTopology rigid = rigid_topology(gromacs, {}, nullptr);
  REQUIRE(rigid.topology.parts.size() == 1);
  CHECK(rigid.topology.parts[0].count == 3);
  CHECK(rigid.origins[0] == "rigid by settles");
  CHECK(rigid.mixing.rule == MixingRule::lorentz_berthelot);
  const Molecule& water = rigid.topology.parts[0].molecule;
  const Molecule own = read_molecule("spce");
  // H-H is given with five digits: 5e-6 nm in 0.1633.
  for (std::size_t k = 0; k < 3; ++k) CHECK(std::abs(water.J[k] / own.J[k] - 1) < 2 * 5e-6 / 0.08);
  CHECK(water.sites[0].element == "O");
  CHECK(water.sites[1].charge == 0.4238);
}

TEST_CASE("interleaved blocks of molecules become interleaved parts") {
  const auto parts =
      rigid_topology(parsed(spce + "NA 2\nSOL 1\nSOL 4\nNA 0\n"), {}, nullptr).topology.parts;
  REQUIRE(parts.size() == 3);
  CHECK(parts[0].count == 3);
  CHECK(parts[1].molecule.top == Top::atom);
  CHECK(parts[1].molecule.charge() == 1);  // of its type
  CHECK(parts[2].count == 5);
  CHECK(parts[2].molecule.name == "SOL");
}

TEST_CASE("the preprocessor handles includes, macros, conditions and continuation lines") {
  const std::string text = replaced(
      replaced(spce, "[ settles ]\n1 1 0.1 0.16330\n",
               "#ifndef FLEXIBLE\n[ settles ]\n1 1 \\\ndoh dhh ; both\n#else\n[ bonds ]\n1 2 "
               "1 0.1\n1 3 1 "
               "0.1\n#ifdef NEVER\n#error never\n#endif\n[ angles ]\n2 1 3 1 109.47\n#endif\n"),
      "[ defaults ]\n", "* a line of comment\n#include \"lengths.itp\"\n[defaults] ; here\n");
  const IncludeLoader loader =
      includes("#define doh 0.1\n#define twice dhh\n#define dhh twice 0.16330\n");
  CHECK_THROWS(parsed(text, loader));  // 'twice dhh' stays: no macro is replaced within itself
  const IncludeLoader good = includes("#define doh 0.1\n#define hh 0.16330\n#define dhh hh\n");
  CHECK(rigid_topology(parsed(text, good), {}, nullptr).origins[0] == "rigid by settles");
  check_error([&] { rigid_topology(parsed(text, good, {"FLEXIBLE"}), {}, nullptr); },
              {"molecule type 'SOL' is not held rigid", "rigid = [\"SOL\"]", "topol.top:"});
  const RigidTopology declared =
      rigid_topology(parsed(text, good, {"FLEXIBLE"}), {.rigid = {"SOL"}}, nullptr);
  CHECK(declared.origins[0] == "declared rigid, shape from bonds and angles");
  const Molecule own = read_molecule("spce");  // 109.47 degrees, from the bonds and angles
  CHECK(std::abs(declared.topology.parts[0].molecule.J.x / own.J.x - 1) < 1e-9);
}

TEST_CASE("a comment includes its continuation lines, as in GROMACS") {
  const std::string text = replaced(spce, "[ settles ]\n1 1 0.1 0.16330\n",
                                    "[ settles ]\n; 1 1 0.9 \\\n0.9 0.9\n1 1 0.1 0.16330\n");
  CHECK(rigid_topology(parsed(text), {}, nullptr).origins[0] == "rigid by settles");
}

TEST_CASE("the preprocessor refuses endless input") {
  refused("#include \"a\"\n", {"'a' includes itself", "a:1"}, includes("#include \"a\"\n"));
  int k = 0;
  refused("#include \"a\"\n", {"included files are nested 32 levels deep"},
          [&](const std::string&, const std::string&) {
            return LoadedText{fmt::format("{}", ++k), "#include \"a\"\n"};
          });
  std::string doubling = "#define a0 x x\n", empty = "#define a0\n";
  for (int i = 1; i < 16; ++i) {
    std::string ten;
    for (int n = 0; n < 10; ++n) ten += fmt::format(" a{}", i - 1);
    for (std::string* text : {&doubling, &empty}) *text += fmt::format("#define a{}{}\n", i, ten);
  }
  refused(doubling + "a15\n", {"longer than 65536 characters when macros are replaced"});
  refused(empty + "a15\n", {"longer than 65536 characters when macros are replaced"});
  std::string nested;
  for (int i = 0; i < 300; ++i) nested += "#ifdef A\n";
  refused(nested, {"conditions are nested 256 levels deep", "topol.top:257"});
  refused("#ifdef A\n", {"the file ends before the #endif", "topol.top:1"});
  refused("#endif\n", {"no #ifdef or #ifndef in this file before this #endif"});
  refused("#if A\n", {"there is no directive '#if'"});
  refused("#error use another\n", {"stops with #error: use another", "topol.top:1"});
  refused("\n#include \"gone.itp\"\n", {"there is no file 'gone.itp'", "topol.top:2"});
}

TEST_CASE("errors in topologies give the line, what was found and what was expected") {
  refused("", {"contains no molecules"});
  refused("SOL 3\n", {"'SOL 3' precedes the first section", "topol.top:1"});
  refused("[ defaults\n", {"must end with ']'"});
  refused("[ atomtype ]\n", {"there is no section [ atomtype ]; did you mean 'atomtypes'?"});
  refused(replaced(spce, "1 2\n", "3 1\n"),
          {"nbfunc is 3; it must be 1, Lennard-Jones, or 2, Buckingham", "topol.top:2"});
  refused(replaced(spce, "1 2\n", "1 4\n"),
          {"found '4' for the comb-rule, which must be a whole number from 1 to 3"});
  refused(replaced(spce, "0.650629", "-1"),
          {"epsilon = -1; both must be 0 or more", "topol.top:4"});
  refused(replaced(spce, "0.650629", "nan"), {"the epsilon is nan; it must be a finite number"});
  refused(replaced(spce, "8 15.9994 0 A", "8 15.9994 0 0"), {"is a particle type (A, V, D or S)"});
  refused(replaced(spce, "2 HW 1 SOL HW1", "5 HW 1 SOL HW1"), {"found atom 5 instead of atom 2"});
  refused(replaced(spce, "1 OW 1", "1 OX 1"),
          {"atom type 'OX' is not defined before this line", "topol.top:10"});
  refused(replaced(spce, "SOL 3\n", "SOK 3\n"),
          {"molecule type 'SOK' is not defined", "did you mean 'SOL'?"});
  refused(replaced(spce, "SOL 3\n", "SOL -3\n"),
          {"found '-3' for the count, which must be a whole number"});
  refused(replaced(spce, "0.16330", "0.3"),
          {"molecule type 'SOL' is not held rigid", "the other distances give"});
  refused(replaced(spce, "[ settles ]\n1 1", "[ settles ]\n2 1"),
          {"atom 2 must be followed by two hydrogen atoms"});
  refused(
      replaced(spce, "[ settles ]\n1 1 0.1 0.16330\n", "[ bonds ]\n1 2 1 0.1\n"),
      {"not held rigid by settles or constraints: 0 distances do not determine the positions of 3",
       "topol.top:14"});
  refused(
      replaced(spce, "[ settles ]", "[ position_restraints ]\n1 1 1 1 1\n[ settles ]"),
      {"has a section [ position_restraints ], but rigid bodies cannot have one", "topol.top:14"});
  refused(replaced(spce, "[ settles ]", "[ virtual_sites3 ]\n3 1 2 2 1 0.1 0.1\n[ settles ]"),
          {"two different atoms and not between virtual sites"});
}

TEST_CASE("pairs of atom types become pairs of sites, in sigma and epsilon") {
  const std::string pair =
      "[ nonbond_params ]\nNA OW 1 0.31 0.25\nOW NA 1 0.31 0.25\nHW OW 1 0 0\n[ moleculetype ]\n";
  const std::string text = replaced(spce, "[ moleculetype ]\n", pair) + "NA 1\n";
  const auto mixing = rigid_topology(parsed(text), {}, nullptr).mixing;
  REQUIRE(mixing.pairs.size() == 1);
  CHECK(mixing.pairs[0].sigma == 0.31);
  CHECK(mixing.pairs[0].epsilon == 0.25);
  const auto other = parsed(replaced(text, "NA OW 1 0.31", "NA OW 1 0.3"));
  check_error(
      [&] { rigid_topology(other, {}, nullptr); },
      {"the pair of atom types 'OW' and 'NA' is already defined in topol.top", "other parameters"});
  // Combination rule 1: C6 and C12 of sigma 0.3 and epsilon 0.5.
  std::string powers = replaced(text, "1 2\n", "1 1\n");
  const double c6 = 4 * 0.5 * std::pow(0.3, 6), c12 = c6 * std::pow(0.3, 6);
  powers = replaced(powers, "0.316557 0.650629", fmt::format("{} {}", c6, c12));
  const RigidTopology geometric = rigid_topology(parsed(powers), {}, nullptr);
  CHECK(geometric.mixing.rule == MixingRule::geometric);
  CHECK(geometric.topology.parts[0].molecule.sites[0].sigma == doctest::Approx(0.3).epsilon(1e-12));
  CHECK(geometric.topology.parts[0].molecule.sites[0].epsilon ==
        doctest::Approx(0.5).epsilon(1e-12));
  refused(replaced(text, "HW OW 1 0 0", "HW OW 1 0.3 0.1"),
          {"one of these types has no potential with itself"});
}

TEST_CASE("with nbfunc 2 atom types and pairs have Buckingham laws") {
  std::string text = replaced(spce, "1 2\n", "2 1\n");
  text = replaced(text, "0.316557 0.650629", "9e5 38 2.6e-3");
  text = replaced(text, "HW 1 1.008 0 A 0 0", "HW 1 1.008 0 A 0 0 0");
  text = replaced(text, "0.2584 0.4184", "4e5 42 1e-3");
  const std::string pair = "[ nonbond_params ]\nNA OW 2 5e5 40 2e-3\n[ moleculetype ]\n";
  text = replaced(text, "[ moleculetype ]\n", pair) + "NA 1\n";
  const RigidTopology rigid = rigid_topology(parsed(text), {}, nullptr);
  const auto& sites = rigid.topology.parts[0].molecule.sites;
  CHECK(sites[0].law == ShortRangeLaw(BuckinghamLaw{9e5, 38, 2.6e-3}));
  CHECK(!sites[1].has_short_range());
  REQUIRE(rigid.mixing.pairs.size() == 1);
  CHECK(rigid.mixing.pairs[0].law == ShortRangeLaw(BuckinghamLaw{5e5, 40, 2e-3}));
  refused(replaced(text, "NA OW 2 5e5", "NA OW 1 5e5"), {"the function type is 1; it must be 2"});
  refused(replaced(text, "9e5 38 2.6e-3", "9e5 38"),
          {"three parameters A, B and C", "topol.top:4"});
  refused(replaced(text, "9e5 38 2.6e-3", "-9e5 38 0"), {"A = -900000", "topol.top:4"});
}

TEST_CASE("virtual sites have the positions that GROMACS gives them") {
  // With a right angle of unit legs every weight is a coordinate.
  const auto site = [](const std::string& line) {
    const std::string text =
        "[ defaults ]\n1 2\n[ atomtypes ]\nA A 1 1 0 A 0 0\n[ moleculetype ]\nM 1\n[ atoms ]\n"
        "1 A 1 M A 1 0 1\n2 A 1 M B 1 0 1\n3 A 1 M C 1 0 1\n4 A 1 M V 1 1 0\n[ constraints ]\n"
        "1 2 1 1\n1 3 1 1\n2 3 1 1.4142135623730951\n" +
        line + "\n[ molecules ]\nM 1\n";
    const Molecule m = rigid_topology(parsed(text), {}, nullptr).topology.parts[0].molecule;
    const auto& s = m.sites;
    const Vec3<double> x = s[1].r - s[0].r, y = s[2].r - s[0].r, v = s[3].r - s[0].r;
    return Vec3<double>{dot(v, x), dot(v, y), dot(v, cross(x, y))};
  };
  const auto check = [&](const std::string& line, const Vec3<double>& expected) {
    CAPTURE(line);
    CHECK(norm(site(line) - expected) < 1e-12);
  };
  check("[ virtual_sites2 ]\n4 1 2 1 0.25", {0.25, 0, 0});
  check("[ dummies2 ]\n4 1 3 2 0.3", {0, 0.3, 0});
  check("[ virtual_sites3 ]\n4 1 2 3 1 0.1 0.2", {0.1, 0.2, 0});
  check("[ dummies3 ]\n4 1 2 3 4 0.1 0.2 -0.3", {0.1, 0.2, -0.3});
  check("[ virtual_sites3 ]\n4 1 2 3 2 0.5 0.1", {0.1 * std::sqrt(0.5), 0.1 * std::sqrt(0.5), 0});
  check("[ virtual_sites3 ]\n4 1 2 3 3 60 0.1", {0.05, 0.1 * std::sqrt(0.75), 0});
}

TEST_CASE(
    "a molecule declared rigid without a determined shape gets its mean shape in the initial "
    "configuration") {
  const std::string text = replaced(spce, "[ settles ]\n1 1 0.1 0.16330\n", "");
  const Shape truth = {{0, 0, 0}, {0.1, 0, 0}, {-0.0333, 0.0943, 0}};
  Shape longer = truth, shorter = truth;  // one bond, by 1 pm
  longer[1].x += 0.001, shorter[1].x -= 0.001;
  check_error(
      [&] { rigid_topology(parsed(text), {.rigid = {"SOL"}}, nullptr); },
      {"do not determine a shape; give an initial configuration that contains this molecule type",
       "topol.top:8"});
  const Frame start = start_of({truth, longer, shorter});
  const RigidTopology rigid = rigid_topology(parsed(text), {.rigid = {"SOL"}}, &start);
  CHECK(rigid.origins[0] == "declared rigid, mean shape from the initial configuration");
  // The superposition of the first onto the others has a second-order error: 0.001² / 0.1 nm.
  CHECK(difference(shape_of(rigid), truth) < 1e-5);
  const double deviation = fit_state(start, rigid.topology).deviation;
  CHECK(deviation < 0.001);  // a fit spreads it over the atoms
  CHECK(deviation > 0.0003);
  const Frame one = start_of({truth});
  check_error([&] { rigid_topology(parsed(text), {.rigid = {"SOL"}}, &one); },
              {"the initial configuration ends after 3 atoms, before the end of molecules 'SOL'"});
}

TEST_CASE("a mean shape has the same axes whatever the orientation of the molecules") {
  const std::string text = replaced(spce, "[ settles ]\n1 1 0.1 0.16330\n", "");
  const Shape bent = {{0, 0, 0}, {0.1, 0, 0}, {-0.0333, 0.0943, 0}};
  const TopologySettings settings{.rigid = {"SOL"}};
  const Frame start = start_of({bent, bent, bent});
  const Shape first = shape_of(rigid_topology(parsed(text), settings, &start));
  for (int k = 0; k < 20; ++k) {
    CAPTURE(k);
    const auto turn = rotation_quaternion(Vec3<double>{1.0 * k, 2 - 0.3 * k, 0.7});
    Shape turned = bent;
    for (Vec3<double>& r : turned) r = to_lab(turn, r);
    const Frame other = start_of({turned, bent, turned});
    const Shape shape = shape_of(rigid_topology(parsed(text), settings, &other));
    for (std::size_t i = 0; i < 3; ++i) CHECK(norm(shape[i] - first[i]) < 1e-12);
  }
}

TEST_CASE("a given shape takes the place of the derived one, and must fit it") {
  const std::string text = replaced(spce, "[ settles ]\n1 1 0.1 0.16330\n", "");
  const Shape bent = {{0, 0, 0}, {0.1, 0, 0}, {-0.02, 0.09, 0}};
  TopologySettings settings{.shapes = {{"SOL", bent}}};
  const RigidTopology rigid = rigid_topology(parsed(text), settings, nullptr);
  CHECK(rigid.origins[0] == "rigid, shape from the run file");
  CHECK(difference(shape_of(rigid), bent) < 1e-12);
  // Written down, in its principal frame, it gives the same axes.
  settings.shapes = rigid.shapes;
  const Shape again = shape_of(rigid_topology(parsed(text), settings, nullptr));
  for (std::size_t i = 0; i < 3; ++i) CHECK(norm(again[i] - shape_of(rigid)[i]) < 1e-15);

  const auto with = [&](const std::string& name, const Shape& shape) {
    return TopologySettings{.shapes = {{name, shape}}};
  };
  check_error(
      [&] {
        rigid_topology(parsed(text), with("SOL", {{}, {0.1, 0, 0}}), nullptr);
      },
      {"2 positions", "must have 3", "topol.top:8"});
  check_error([&] { rigid_topology(parsed(text), with("SAL", bent), nullptr); },
              {"'SAL' has a shape", "SOL", "topol.top"});
  check_error([&] { rigid_topology(parsed(spce), settings, nullptr); },
              {"atoms 1 and 3", "its settles or constraints give 0.1 nm", "topol.top:8"});
  // Settles determine the shape, so nothing is to be written down.
  CHECK(rigid_topology(parsed(spce), {}, nullptr).shapes.empty());
}

TEST_CASE("of two mirror images that of the initial configuration is taken") {
  const Shape right = {{0, 0, 0}, {0.1, 0, 0}, {0.02, 0.15, 0}, {0.03, 0.04, 0.12}};
  std::string text =
      "[ defaults ]\n1 2\n[ atomtypes ]\nA A 6 12 0 A 0 0\n[ moleculetype ]\nM 1\n[ atoms ]\n";
  for (int k = 1; k <= 4; ++k) text += fmt::format("{0} A 1 M C{0} 1 0 12\n", k);
  text += "[ constraints ]\n";
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < i; ++k)
      text += fmt::format("{} {} 1 {:.16g}\n", k + 1, i + 1, norm(right[i] - right[k]));
  text += "[ molecules ]\nM 1\n";
  for (const Shape& shape : {right, mirror_image(right)}) {
    const Frame start = start_of({shape});
    const RigidTopology rigid = rigid_topology(parsed(text), {}, &start);
    CHECK(rigid.origins[0] == "rigid by constraints");
    CHECK(difference(shape_of(rigid), shape) < 1e-8);  // see distances_test.cpp
    CHECK(difference(shape_of(rigid), mirror_image(shape)) > 0.01);
  }
}

TEST_CASE("force fields and boxes distributed with GROMACS are read") {
  const auto data = gromacs_data_folder();
  if (!data) return skip("GROMACS data is not installed; on Debian: apt-get install gromacs-data");
  struct Case {
    const char *field, *water, *box;
    double oxygen;  // sigma [nm]
  };
  const auto gromos = [&](const char* water) {
    return fmt::format(
        "#include \"gromos54a7.ff/forcefield.itp\"\n#include \"gromos54a7.ff/{}.itp\"\n", water);
  };
  for (const char* water : {"tip3p", "tip4p"})  // of types that this force field does not have
    check_error([&] { parse_gromacs(gromos(water), "topol.top", file_loader({})); },
                {"atom type 'OWT", "before this line", water, ".itp:"});
  for (const Case& c : {Case{"amber99sb-ildn", "spce", "spc216", 0.316557},
                        {"amber99sb-ildn", "tip3p", "spc216", 0.315061},
                        {"amber99sb-ildn", "tip4p", "tip4p", 0.315365},
                        {"amber99sb-ildn", "tip5p", "tip5p", 0.312},
                        {"oplsaa", "spc", "spc216", 0.316557},
                        {"oplsaa", "tip4p", "tip4p", 0.315365},
                        {"oplsaa", "tip5p", "spc216", 0.312},
                        {"charmm27", "tips3p", "spc216", 0.315057},
                        {"charmm27", "tip3p", "spc216", 0.315058},
                        {"charmm27", "tip4p", "tip4p", 0.315365},
                        {"charmm27", "tip5p", "spc216", 0.312},
                        {"gromos54a7", "spc", "spc216", 0.316557},
                        {"gromos54a7", "spce", "spc216", 0.316557}}) {
    CAPTURE(c.field);
    CAPTURE(c.water);
    const Frame frame = read_start(*data + '/' + c.box + ".gro");
    const std::string box = c.box;
    const std::size_t atoms = box == "tip5p" ? 5 : box == "tip4p" ? 4 : 3;  // of a molecule there
    const std::string text = fmt::format(
        "#include \"{0}.ff/forcefield.itp\"\n#include \"{0}.ff/{1}.itp\"\n#include "
        "\"{0}.ff/ions.itp\"\n"
        "[ system ]\nwater\n[ molecules ]\nSOL {2}\n",
        c.field, c.water, frame.atoms.size() / atoms);
    const RigidTopology rigid =
        rigid_topology(parse_gromacs(text, "topol.top", file_loader({})), {}, &frame);
    const Molecule& water = rigid.topology.parts[0].molecule;
    CHECK(water.sites.size() >= atoms);  // massless sites may be missing in the box
    CHECK(water.sites[0].sigma == doctest::Approx(c.oxygen).epsilon(1e-4));
    CHECK(std::abs(water.charge()) < 1e-12);
    // Three decimals leave 0.9 pm, and the models of water differ by a few pm.
    const FittedState fitted = fit_state(frame, rigid.topology);
    CHECK(fitted.deviation < 0.02);
    CHECK(fitted.deviation > 1e-4);
    if (box ==
        "tip5p")  // its two lone pairs have the opposite order, 2 × 0.07 sin(109.47°/2) nm apart
      CHECK(std::abs(fitted.massless_deviation - 0.1143) < 0.01);
    else
      CHECK(fitted.massless_deviation < 0.02);
  }
}
