// SPDX-License-Identifier: MIT
#include "io/topology/lammps_data.hpp"

#include <cmath>

#include "../errors.hpp"

using namespace polhode;

namespace {

// Two waters, with unordered atoms across the boundary, and a sodium ion.
const std::string good_data =
    "LAMMPS data file via write_data, units = real\n"
    "\n"
    "7 atoms\n"
    "3 atom types\n"
    "4 bonds\n"
    "-10 10 xlo xhi\n"
    "-10 10 ylo yhi\n"
    "0 20 zlo zhi\n"
    "\n"
    "Masses\n"
    "\n"
    "1 15.9994\n"
    "2 1.008 # hydrogen\n"
    "3 22.99\n"
    "\n"
    "Pair Coeffs # lj/cut/coul/long\n"
    "\n"
    "1 0.1553 3.166\n"
    "2 0 0\n"
    "3 0.1 2.5\n"
    "\n"
    "Atoms # full\n"
    "\n"
    "3 1 2 0.4238 -0.333 0.943 1 0 0 0\n"
    "1 1 1 -0.8476 0 0 1 0 0 0\n"
    "2 1 2 0.4238 1 0 1 0 0 0\n"
    "9 0 3 1 5 5 5 0 0 0\n"
    "4 2 1 -0.8476 9.5 5 1 0 0 0\n"
    "5 2 2 0.4238 -9.5 5 1 1 0 0\n"
    "6 2 2 0.4238 9.167 5.943 1 0 0 0\n"
    "\n"
    "Velocities\n"
    "\n"
    "9 0.01 0 0\n"
    "\n"
    "Bonds\n"
    "\n"
    "1 1 1 2\n";

void refused(const std::string& text, std::initializer_list<const char*> parts) {
  check_error([&] { rigid_topology(parse_lammps_data(text, "a.data")); }, parts);
}

}  // namespace

TEST_CASE("molecule ids of a LAMMPS data file define bodies, and equal ones are of one kind") {
  const LammpsData read = parse_lammps_data(good_data, "a.data");
  REQUIRE(read.kinds.size() == 2);
  CHECK(read.kinds[0].name == "Na");  // molecule 0: an atom by itself
  CHECK(read.kinds[1].name == "OH2");
  CHECK(read.kinds[1].count == 2);
  CHECK(read.kinds[1].sites == std::vector<std::string>{"O", "H1", "H2"});
  const RigidTopology rigid = rigid_topology(read);
  REQUIRE(rigid.topology.parts.size() == 2);
  const Molecule& water = rigid.topology.parts[1].molecule;
  CHECK(water.sites[0].epsilon == doctest::Approx(0.1553 * 4.184).epsilon(1e-15));
  CHECK(water.sites[0].sigma == doctest::Approx(0.3166).epsilon(1e-15));
  CHECK(norm(water.sites[1].r - water.sites[0].r) == doctest::Approx(0.1).epsilon(1e-12));
  CHECK(rigid.rule_matters);  // of oxygen and sodium, which no PairIJ Coeffs give
  const Frame frame = frame_of(read);
  CHECK(frame.box.edge.x == 2);
  CHECK(frame.atoms[0].r == Vec3<double>{1.5, 1.5, 0.5});             // from the lower corner
  CHECK(frame.atoms[0].v.x == doctest::Approx(1).epsilon(1e-15));     // 0.01 Å/fs
  CHECK(frame.atoms[5].r.x == doctest::Approx(2.05).epsilon(1e-15));  // unwrapped by its image flag
  const FittedState fitted = fit_state(frame, rigid.topology);
  CHECK(fitted.deviation < 1e-12);
  CHECK(fitted.state.p[0].x == doctest::Approx(22.99).epsilon(1e-15));
}

TEST_CASE("PairIJ Coeffs define every pair") {
  std::string text =
      replaced(good_data, "Pair Coeffs # lj/cut/coul/long\n\n1 0.1553 3.166\n2 0 0\n3 0.1 2.5\n",
               "PairIJ Coeffs\n\n1 1 0.1553 3.166\n1 2 0 0\n1 3 0.2 3\n2 2 0 0\n3 3 0.1 2.5\n");
  const RigidTopology rigid = rigid_topology(parse_lammps_data(text, "a.data"));
  CHECK(!rigid.rule_matters);
  REQUIRE(rigid.mixing.pairs.size() == 1);
  CHECK(rigid.mixing.pairs[0].epsilon == doctest::Approx(0.2 * 4.184).epsilon(1e-15));
}

TEST_CASE("pair styles buck and mie/cut have their laws") {
  std::string buck = replaced(good_data, "lj/cut/coul/long", "buck/coul/long");
  buck = replaced(buck, "1 0.1553 3.166\n2 0 0\n3 0.1 2.5\n", "1 2e5 0.26 600\n2 0 1 0\n3 0 1 0\n");
  const auto oxygen = [](const std::string& text) {
    return rigid_topology(parse_lammps_data(text, "a.data")).topology.parts[1].molecule.sites[0];
  };
  const auto law = std::get<BuckinghamLaw>(oxygen(buck).law);
  CHECK(law.A == doctest::Approx(2e5 * 4.184).epsilon(1e-14));
  CHECK(law.B == doctest::Approx(1 / 0.026).epsilon(1e-14));
  CHECK(law.C == doctest::Approx(600 * 4.184e-6).epsilon(1e-14));
  CHECK(!rigid_topology(parse_lammps_data(buck, "a.data"))
             .topology.parts[0]
             .molecule.sites[0]
             .has_short_range());
  refused(replaced(buck, "3 0 1 0\n", "3 2e5 0.2 0\n"), {"no mixing rule", "pair ij"});
  refused(replaced(buck, "1 2e5 0.26 600", "1 2e5 0.26"), {"A, rho and C", "a.data:18"});
  refused(replaced(buck, "1 2e5 0.26 600", "1 -2e5 0.26 600"), {"A = -", "a.data:18"});

  std::string mie = replaced(good_data, "lj/cut/coul/long", "mie/cut");
  mie = replaced(mie, "1 0.1553 3.166\n2 0 0\n3 0.1 2.5\n",
                 "1 0.1553 3.166 14 6\n2 0 0 12 6\n3 0 0 12 6\n");
  CHECK(oxygen(mie).law == ShortRangeLaw(MieLaw{14, 6}));
  CHECK(oxygen(mie).sigma == doctest::Approx(0.3166).epsilon(1e-15));
  refused(replaced(mie, "1 0.1553 3.166 14 6", "1 0.1553 3.166 14 2"), {"14 and 2", "a.data:18"});
}

TEST_CASE("a data file without the number of atom types is refused with this reason") {
  for (const char* header : {"", "0 atom types\n"})
    refused(replaced(good_data, "3 atom types\n", header),
            {"the header does not contain the number of atom types", "a.data"});
}

TEST_CASE("a data file with an unsupported pair style still has coordinates") {
  for (const char* style : {"hybrid", "hybrid/overlay", "morse"}) {
    CAPTURE(style);
    std::string text = replaced(good_data, "lj/cut/coul/long", style);
    text = replaced(text, "1 0.1553 3.166", "1 lj/cut 0.1553 3.166");
    text = replaced(text, "2 0 0", "2 morse 100 2 1.5");
    check_error([&] { rigid_topology(parse_lammps_data(text, "a.data")); },
                {style, "not supported", "mie/cut", "a.data"});
    CHECK(parse_lammps_data(text, "a.data").atoms.size() == 7);
  }
  refused(replaced(good_data, "lj/cut/coul/long", "hybrid"),
          {"the pair style is 'hybrid', and pairs of atoms with different styles are not supported",
           "molecules = [{ model = \"spce\", count ="});
}

TEST_CASE("errors in LAMMPS data files give the line, what was found and what was expected") {
  refused("", {"the header does not contain the number of atoms"});
  refused(replaced(good_data, "real", "metal"),
          {"the units are 'metal'; they must be 'real'", "a.data:1"});
  refused(replaced(good_data, "0 20 zlo zhi", "0 20 zlo zhi\n1 0 0 xy xz yz"),
          {"the box is triclinic", "a.data:9"});
  refused(replaced(good_data, "0 20 zlo", "20 0 zlo"), {"the box extends from 20 to 0"});
  refused(replaced(good_data, "0 20 zlo zhi\n", ""), {"the atoms precede the box"});
  refused(replaced(good_data, "# full", "# molecular"),
          {"the atom style is 'molecular'; it must be full"});
  refused(replaced(good_data, "7 atoms", "8 atoms"),
          {"specifies 8 atoms, but the section Atoms has 7"});
  refused(replaced(good_data, "1 1 1 -0.8476", "2 1 1 -0.8476"), {"two atoms with the id 2"});
  refused(replaced(good_data, "9 0 3 1 5 5 5 0 0 0", "9 0 4 1 5 5 5 0 0 0"),
          {"found '4' for the atom type, which must be a whole number from 1 to 3", "a.data:27"});
  refused(replaced(good_data, "5 5 5 0 0 0", "5 5 nan 0 0 0"), {"z coordinate is nan"});
  refused(replaced(good_data, "5 5 5 0 0 0", "5 5 5 0"),
          {"it must have 7, or 10 with image flags"});
  refused(replaced(good_data, "3 22.99\n", ""), {"atom type 3 has no mass"});
  refused(replaced(good_data, "Bonds", "Ellipsoids"), {"there is no section 'Ellipsoids'"});
  refused(replaced(good_data, "9 0.01", "8 0.01"), {"a velocity for atom 8, but no such atom"});
  refused(replaced(good_data, "lj/cut/coul/long", "lj/cut/soft"),
          {"the pair style 'lj/cut/soft' is not supported; use mie/cut, lj/cut or buck"});
  refused(replaced(good_data, "lj/cut/coul/long", "table"),
          {"the pair style 'table' is not supported", "tabulated"});
  refused(replaced(good_data, "lj/cut/coul/long", "lj/cut/tip4p/long"),
          {"site M is not in the data file", "tip4p"});
  refused(replaced(good_data, "3 0.1 2.5\n", ""), {"atom type 3 has no short-range parameters"});
}
