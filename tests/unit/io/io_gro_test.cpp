// SPDX-License-Identifier: MIT
#include "io/coordinates/gro.hpp"

#include <cmath>
#include <sstream>

#include "../errors.hpp"
#include "polhode/base/units.hpp"
#include "polhode/io/coordinates/frame_file.hpp"
#include "polhode/io/topology/molecule_file.hpp"

using namespace polhode;

namespace {

const std::string atoms =
    "    1SOL     OW    1   0.100   0.200   0.300\n"
    "    1SOL    HW1    2   0.200   0.200   0.300\n"
    "    1SOL    HW2    3   0.067   0.294   0.300\n";
const std::string box = "   2.00000   2.00000   2.00000\n";
const std::string water = "water\n3\n" + atoms + box;

void check_gro(const std::string& text, std::initializer_list<const char*> parts) {
  check_error([&] { parse_gro(text, "a.gro"); }, parts);
}

// All molecules' kinetic energy [kJ/mol].
double kinetic_energy(const State& state, const Topology& topology) {
  const Bodies bodies(topology);
  double twice = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Vec3<double> L = to_body(state.orientation[i], state.ell[i]);
    twice += norm2(state.p[i]) * bodies.inverse_m[i] + dot(L, scaled(bodies.inverse_J[i], L));
  }
  return twice / 2;
}

double largest_difference(const Vec3Column& a, const Vec3Column& b) {
  double d = 0;
  for (std::size_t i = 0; i < a.size(); ++i) d = std::max(d, norm(a[i] - b[i]));
  return d;
}

}  // namespace

TEST_CASE("GRO files with any number of decimals are read") {
  const Frame frame = parse_gro(replaced(water, "water", "water in a box t=  1.500 step= 3"), "x");
  CHECK(frame.atoms.size() == 3);
  CHECK(frame.kind(frame.atoms[1]).name == "HW1");
  CHECK(frame.kind(frame.atoms[1]).residue_name == "SOL");
  CHECK(frame.atoms[2].r.y == 0.294);
  CHECK(!frame.has_velocities);
  CHECK(frame.box.edge.y == 2);
  CHECK(frame.time == 1.5);
  // The water box of GROMACS omits the zero before the decimal point.
  const Frame wide = parse_gro(
      "w\r\n1\r\n    1SOL     OW    1    .2301   -.6281    .1131   .10000  "
      "-.20000   .30000\r\n 1 2 3\r\n",
      "x");
  CHECK(wide.atoms[0].r == Vec3<double>{0.2301, -0.6281, 0.1131});
  CHECK(wide.atoms[0].v == Vec3<double>{0.1, -0.2, 0.3});
}

TEST_CASE("the time in the title follows the last word t=") {
  const auto time = [](const std::string& title) {
    return parse_gro(replaced(water, "water", title), "x").time;
  };
  CHECK(time("count=500") == 0);
  CHECK(time("seed_t=3 dt=0.5 Set=7") == 0);
  CHECK(time("t= 1.5 count=500") == 1.5);
  CHECK(time("t=1 water, t=2.5 step=500 weight=18") == 2.5);
  CHECK(time("water (t= 4 )") == 4);
}

TEST_CASE("errors in GRO files give the line, what was found and what was expected") {
  check_gro("", {"the file ends before its title", "a.gro:1"});
  check_gro("water\n", {"the file ends before the number of atoms", "a.gro:2"});
  check_gro(replaced(water, "\n3\n", "\nthree\n"),
            {"found 'three' instead of the number of", ":2"});
  check_gro(replaced(water, "\n3\n", "\n-3\n"), {"found '-3' instead of the number of atoms"});
  check_gro(replaced(water, "\n3\n", "\n4\n"),
            {"instead of atom 4 of 4 (the number in the second line)", "a.gro:6"});
  check_gro(replaced(water, "\n3\n", "\n2\n"),
            {"another atom", "the frame has 2 atoms", "a.gro:5"});
  check_gro("water\n3\n" + atoms, {"the file ends before the box", "a.gro:6"});
  check_gro("water\n3\n" + atoms.substr(0, 90),
            {"the file ends before atom 3 of 3 (the number in the second line)", "a.gro:5"});
  check_gro(
      "water\n3\n" + atoms.substr(0, 87),
      {"the line ends after 42 characters; the names and three coordinates of 8 characters each",
       "need 44 characters", "a.gro:4"});
  check_gro(replaced(water, "0.200   0.300\n", "0.200   0.300  0.1\n"),
            {"ends after 49 characters; the names and three coordinates and three velocities",
             "need 68 characters"});
  check_gro(replaced(water, "0.067", "  nan"), {"x coordinate is nan", "finite", "a.gro:5"});
  check_gro(replaced(water, "0.067", "0.O67"), {"found '0.O67' for the x coordinate"});
  check_gro(replaced(water, "    1SOL    HW2", "    xSOL    HW2"),
            {"found 'x' instead of the residue number", "a.gro:5"});
  check_gro(replaced(water, "    1SOL    HW2", "    1SOL       "), {"no atom name", "a.gro:5"});
  check_gro(replaced(water, "   0.200   0.300\n", "   0.200\n"), {"before its third coordinate"});
  check_gro(replaced(water, "   0.200   0.300\n", "   0.200    0.300\n"),
            {"8 and 9 characters apart", "a.gro:3"});
  check_gro(replaced(water, "0.294   0.300\n", "0.294   0.300  0.1000  0.1000  0.1000\n"),
            {"either all atoms or no atoms must have velocities", "a.gro:5"});
  check_gro("w\n3\n" + atoms + " 2 2\n", {"found '2 2' instead of the box", "three edges"});
  check_gro("w\n3\n" + atoms + " 2 2 0\n", {"box edge is 0 nm", "longer than 0 nm"});
  check_gro("w\n3\n" + atoms + " 2 2 inf\n", {"the box edge is inf", "finite"});
  check_gro("w\n3\n" + atoms + " 2 2 2 0 0 1 0 0 0\n", {"triclinic", "orthorhombic"});
  check_error([] { read_start("w51"); }, {"no readable file 'w51'"});
}

TEST_CASE("a truncated GRO file gives an error or is complete") {
  const std::string whole = water;
  for (std::size_t length = 0; length < whole.size(); ++length) {
    CAPTURE(length);
    bool read = false;
    try {
      read = parse_gro(whole.substr(0, length), "a.gro").atoms.size() == 3;
    } catch (const Error& e) {
      CHECK(e.where().find("a.gro:") == 0);
    }
    // Only a missing end of the last number may go undetected.
    CHECK(read == (length >= whole.size() - 7));
  }
}

TEST_CASE("atoms that do not match the model are refused") {
  const Molecule tip4p = read_molecule("tip4p");
  const auto check_fit = [&](const std::string& text, std::size_t count,
                             std::initializer_list<const char*> parts) {
    check_error([&] { fit_state(parse_gro(text, "a.gro"), {{{tip4p, count}}}); }, parts);
  };
  check_fit(replaced(water, " OW ", "  N "), 1,
            {"atom 1 (1 SOL) is 'N' instead of site 'OW' of molecule 'tip4p'", "a.gro"});
  check_fit(water, 2, {"the 3 atoms form only 1 of 2 molecules", "set the number of molecules"});
  check_fit(water, 0, {"the file has 3 atoms, but the 0 molecules have 0"});
  check_fit(
      replaced(water, "0.067   0.294", "0.001   0.200"), 1,
      {"nm from its site in the rigid model 'tip4p'", "must be at most 0.02 nm", "molecule 1"});
  check_fit(replaced(water, "2.00000   2.00000   2.00000", " 0.3 3 3"), 1,
            {"nm long", "shorter than half of the shortest box edge (0.300 nm)"});
}

TEST_CASE(
    "three-site water files can be used for a model with a massless site, and determine the "
    "count") {
  const Topology water1 = complete_topology({{{read_molecule("tip4p"), 0}}}, parse_gro(water, "x"));
  CHECK(water1.parts[0].count == 1);
  const FittedState fitted = fit_state(parse_gro(water, "x"), water1);
  CHECK(!fitted.has_velocities);
  CHECK(norm(fitted.state.p[0]) == 0);
  // The file's molecule is 0.1 nm and 109.3 degrees wide, TIP4P 0.09572 nm and 104.52 degrees: the
  // hydrogens' distance is longer by 0.012 nm, half of which applies to each.
  CHECK(fitted.deviation > 0.004);
  CHECK(fitted.deviation < 0.009);
}

TEST_CASE("a molecule broken across the boundary is made whole") {
  const Topology one{{{read_molecule("tip4p"), 1}}};
  const FittedState a = fit_state(parse_gro(water, "x"), one);
  const FittedState b = fit_state(parse_gro(replaced(water, "0.067", "2.067"), "x"), one);
  // 2.067 - 2 differs from 0.067 by the rounding of 2.067.
  CHECK(norm(a.state.q[0] - b.state.q[0]) < 1e-15);
  CHECK(b.deviation == doctest::Approx(a.deviation).epsilon(1e-12));
}

TEST_CASE("W512 is rigid TIP4P at about 297 K") {
  const Frame frame = read_start("w512");
  const Topology topology = complete_topology({{{read_molecule("tip4p"), 0}}}, frame);
  REQUIRE(topology.size() == 512);
  const FittedState fitted = fit_state(frame, topology);
  // Positions have 10 decimals: an atom has an error of at most sqrt(3)/2 units of the last, and so
  // has the body it is compared with, a mean of such atoms.
  CHECK(fitted.deviation < std::sqrt(3.0) * 1e-10);
  CHECK(fitted.has_velocities);
  // Kinetic temperature: 6 N - 3 degrees of freedom, so T fluctuates by T sqrt(2 / 3069) = 7.6 K;
  // four times that.
  const double T = 2 * kinetic_energy(fitted.state, topology) / (3069 * units::boltzmann);
  CAPTURE(T);
  CHECK(std::abs(T - 297) < 4 * 7.6);
  // Rigid bodies have all of the kinetic energy of the atoms.
  double atoms_energy = 0;
  for (std::size_t i = 0; i < frame.atoms.size(); ++i)
    atoms_energy += topology.parts[0].molecule.sites[i % 4].mass * norm2(frame.atoms[i].v) / 2;
  CHECK(kinetic_energy(fitted.state, topology) == doctest::Approx(atoms_energy).epsilon(1e-3));
}

TEST_CASE("writing and reading a GRO file gives the same bodies") {
  const Frame start = read_start("w512");
  const Topology topology{{{read_molecule("tip4p"), 512}}};
  const State state = fit_state(start, topology).state;
  const Frame frame = frame_of(state, topology);
  std::ostringstream out;
  write_gro(out, frame);
  const Frame again = parse_gro(out.str(), "again.gro");
  REQUIRE(again.atoms.size() == frame.atoms.size());
  CHECK(again.kind(again.atoms[5]).name == "HW1");
  double dr = 0, dv = 0;
  for (std::size_t i = 0; i < frame.atoms.size(); ++i) {
    dr = std::max(dr, norm(frame.atoms[i].r - again.atoms[i].r));
    dv = std::max(dv, norm(frame.atoms[i].v - again.atoms[i].v));
  }
  // Half a unit of the last decimal in each of three coordinates.
  CHECK(dr < std::sqrt(3.0) * 0.51e-10);
  CHECK(dv < std::sqrt(3.0) * 0.51e-11);
  const State back = fit_state(again, topology).state;
  // The centre is a mean of the sites. Momenta are sums over sites of mass times dv. ℓ = Σ m x × v
  // errs by Σ m (|x| dv + |v| dr) with Σ m |x| < 0.4 u nm and Σ m |v| < 60 u nm/ps.
  for (std::size_t i = 0; i < state.size(); ++i)
    CHECK(norm(state.box.minimum_image(state.q[i] - back.q[i])) < 1e-10);
  CHECK(largest_difference(state.p, back.p) < 18.1 * 1e-11);
  CHECK(largest_difference(state.ell, back.ell) < 60 * 1e-10);
}

TEST_CASE("without massless sites a frame has only atoms") {
  const Topology topology{{{read_molecule("tip4p"), 512}}};
  const State state = fit_state(read_start("w512"), topology).state;
  const Frame frame = frame_of(state, topology, MasslessSites::omit);
  CHECK(frame.atoms.size() == 3 * 512);
  // Bodies fitted to atoms made of bodies: only rounding of 1e-16 nm times a few.
  CHECK(fit_state(frame, topology).deviation < 1e-14);
}
