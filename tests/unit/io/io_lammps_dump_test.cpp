// SPDX-License-Identifier: MIT
// Dump files of LAMMPS, of atoms and of particles.
#include <fmt/core.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "../errors.hpp"
#include "model/initial_state.hpp"
#include "polhode/io/coordinates/frame_file.hpp"
#include "polhode/io/topology/molecule_file.hpp"

using namespace polhode;

namespace {

const std::string good_dump =
    "ITEM: UNITS\nreal\nITEM: TIME\n1500\nITEM: TIMESTEP\n750\n"
    "ITEM: NUMBER OF ATOMS\n3\nITEM: BOX BOUNDS pp pp pp\n-10 10\n0 30\n5 25.5\n"
    "ITEM: ATOMS id mol type element x yu zs vx vy vz\n"
    "3 1 2 H 1.5 2 0.5 0.01 0.02 0.03\n"
    "1 1 1 O -10 3 0 -0.01 0 0\n"
    "2 1 3 X 9 31 1 0 0 0.5\n";

std::vector<Frame> frames_of(const std::string& text) {
  std::istringstream in(text);
  const auto reader = read_frames(in, "dump", "run.dump");
  std::vector<Frame> frames;
  for (Frame frame; reader->next(frame);) frames.push_back(frame);
  return frames;
}

/// @param by  the columns or the atoms in place of those of the good file
std::string edited_dump(const std::string& from, const std::string& by) {
  return replaced(good_dump, from, by);
}

void check_near(const Vec3<double>& a, const Vec3<double>& b) { CHECK(norm(a - b) < 1e-14); }

// The particles of a state as 'dump custom' writes them, in units real, in the reverse order of
// ids.
std::string particle_dump(const State& state, const Topology& topology) {
  const Bodies bodies(topology);
  std::ostringstream out;
  out.precision(17);
  out << "ITEM: TIME\n"
      << 1e3 * state.time << "\nITEM: TIMESTEP\n1\nITEM: NUMBER OF ATOMS\n"
      << state.size() << "\nITEM: BOX BOUNDS pp pp pp\n";
  for (std::size_t d = 0; d < 3; ++d) out << "0 " << 10 * state.box.edge[d] << '\n';
  out << "ITEM: ATOMS id type xu yu zu vx vy vz d2_orientation[1] d2_orientation[2] "
         "d2_orientation[3] "
         "d2_orientation[4] d2_angular_momentum[1] d2_angular_momentum[2] d2_angular_momentum[3]\n";
  for (std::size_t i = state.size(); i-- > 0;) {
    const Vec3<double> q = 10 * state.q[i], v = 0.01 * (bodies.inverse_m[i] * state.p[i]);
    const Vec3<double> ell = 0.1 * state.ell[i];
    const Quaternion<double> a = state.orientation[i];
    out << i + 1 << " 1";
    for (const double x : {q.x, q.y, q.z, v.x, v.y, v.z, a.w, a.x, a.y, a.z, ell.x, ell.y, ell.z})
      out << ' ' << x;
    out << '\n';
  }
  return out.str();
}

struct DumpFile {
  std::string path = "polhode-test-particles.dump";
  explicit DumpFile(const std::string& text) { std::ofstream(path) << text; }
  ~DumpFile() { std::remove(path.c_str()); }
};

}  // namespace

TEST_CASE("a dump file of LAMMPS") {
  const auto frames = frames_of(good_dump);
  REQUIRE(frames.size() == 1);
  const Frame& frame = frames[0];
  CHECK(frame.time == doctest::Approx(1.5));
  check_near(frame.box.edge, {2, 3, 2.05});
  REQUIRE(frame.atoms.size() == 3);
  check_near(frame.atoms[0].r, {0, 0.3, 0});  // in the order of ids, from the corner of the box
  check_near(frame.atoms[1].r, {1.9, 3.1, 2.05});
  check_near(frame.atoms[2].r, {1.15, 0.2, 1.025});
  check_near(frame.atoms[2].v, {1, 2, 3});
  CHECK(frame.has_velocities);
  CHECK(frame.kind(frame.atoms[0]).name == "O");
  CHECK(frame.kind(frame.atoms[1]).element.empty());
  CHECK(frame.atoms[0].residue == 1);
}

TEST_CASE("units of dump files") {
  const auto metal = frames_of(replaced(good_dump, "real", "metal"));
  check_near(metal[0].atoms[2].v, 1e-3 * Vec3<double>{1, 2, 3});
  CHECK(metal[0].time == doctest::Approx(1500));
  const auto nano = frames_of(replaced(good_dump, "real", "nano"));
  check_near(nano[0].box.edge, {20, 30, 20.5});
  CHECK(nano[0].time == doctest::Approx(1.5e6));
}

TEST_CASE("several frames need times") {
  CHECK(frames_of(good_dump + replaced(good_dump, "1500", "3000")).back().time ==
        doctest::Approx(3));
  const std::string timeless = replaced(good_dump, "ITEM: TIME\n1500\n", "");
  CHECK(frames_of(timeless).size() == 1);
  check_error([&] { frames_of(timeless + timeless); }, {"dump_modify ID time yes"});
}

TEST_CASE("wrong dump files") {
  const std::vector<std::array<std::string, 3>> faults = {
      {"real", "lj", "the units are lj"},
      {"1500", "soon", "for the time, which must be a number"},
      {"ATOMS\n3", "ATOMS\nthree", "instead of the number of atoms"},
      {"pp pp pp", "xy xz yz pp pp pp", "must be rectangular"},
      {"pp pp pp", "ff pp pp", "must be rectangular"},
      {"-10 10", "10 10", "longer than 0"},
      {"ITEM: TIMESTEP", "ITEM: TIMESTEPS", "instead of the beginning of a section"},
      {" yu ", " ywrong ", "no coordinate y"},
      {"1.5 2", "nan 2", "finite"},
      {"3 1 2 H", "3 1", "too short"},
      {"2 1 3 X 9 31 1 0 0 0.5\n", "", "the file ends before atom 3"},
      {"ITEM: NUMBER OF ATOMS\n3\n", "", "number of atoms must be before"},
      {"ITEM: BOX BOUNDS pp pp pp\n-10 10\n0 30\n5 25.5\n", "", "bounds of the box must be before"},
  };
  for (const auto& [from, to, words] : faults) {
    CAPTURE(to);
    check_error([&] { frames_of(replaced(good_dump, from, to)); }, {words.c_str(), "run.dump:"});
  }
}

TEST_CASE("a dump file of particles has the sites of their molecules") {
  const Topology topology{
      {{read_molecule("tip4p"), 20}, {read_molecule("co2"), 3}, {read_molecule("argon"), 2}}};
  State state = lattice(topology, {{2.5, 2.6, 2.7}}, 3);
  draw_momenta(state, topology, 297, 1);
  state.time = 1.25;
  const std::string text = particle_dump(state, topology);
  Frame frame;
  {
    const DumpFile file(text);
    REQUIRE(open_particle_frames(file.path, topology)->next(frame));
  }
  const Frame expected = frame_of(state, topology);
  REQUIRE(frame.atoms.size() == expected.atoms.size());
  CHECK(frame.has_velocities);
  CHECK(frame.time == doctest::Approx(1.25));
  for (std::size_t i = 0; i < frame.atoms.size(); ++i) {
    CHECK(norm(frame.atoms[i].r - expected.atoms[i].r) < 1e-13);
    CHECK(norm(frame.atoms[i].v - expected.atoms[i].v) < 1e-12);
    CHECK(frame.kind(frame.atoms[i]).name == expected.kind(expected.atoms[i]).name);
  }
}

TEST_CASE("wrong dump files of particles") {
  const Topology topology{{{read_molecule("tip4p"), 2}}};
  const State state = lattice(topology, {{2.5, 2.6, 2.7}}, 3);
  const std::string text = particle_dump(state, topology);
  const auto read = [&](const std::string& changed, const Topology& molecules) {
    const DumpFile file(changed);
    Frame frame;
    open_particle_frames(file.path, molecules)->next(frame);
  };
  for (const auto& [from, to] :
       {std::pair{"d2_orientation[3]", "d2_orientation[9]"}, {"d2_orientation[1] ", "c_1 "}})
    check_error([&] { read(replaced(text, from, to), topology); }, {"particles need orientations"});
  std::string old = text;  // the name up to version 0.1 is read
  for (char d = '1'; d <= '4'; ++d)
    old = replaced(old, fmt::format("d2_orientation[{}]", d), fmt::format("d2_attitude[{}]", d));
  CHECK_NOTHROW(read(old, topology));
  check_error(
      [&] {
        read(text, {{{read_molecule("tip4p"), 3}}});
      },
      {"2 particles, but the run file has 3"});
  check_error([&] { open_particle_frames("run.xtc", topology); }, {"is not a LAMMPS dump file"});
}

TEST_CASE("ids that occur twice and incomplete vectors are refused") {
  check_error([] { frames_of(edited_dump("2 1 3 X 9", "1 1 3 X 9")); },
              {"two atoms with the id 1", "ids must differ", "run.dump:"});
  check_error([] { frames_of(edited_dump("vx vy vz", "vx vy fz")); },
              {"velocities have 2 of three components", "vx, vy and vz", "run.dump:13"});
  check_error([] { frames_of(edited_dump("vx vy vz", "vx vy vx")); }, {"two columns vx"});
  check_error([] { frames_of(edited_dump("id mol type", "id mol id")); }, {"two columns id"});
  CHECK_FALSE(frames_of(edited_dump("vx vy vz", "fx fy fz")).front().has_velocities);
}
