// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "../errors.hpp"
#include "../folder.hpp"
#include "model/initial_state.hpp"
#include "polhode/io/coordinates/frame_file.hpp"
#include "polhode/io/topology/molecule_file.hpp"

using namespace polhode;
namespace fs = std::filesystem;

namespace {

Topology some_molecules() { return {{{read_molecule("tip4p"), 60}, {read_molecule("argon"), 4}}}; }

State some_state(const Topology& topology, double time) {
  State state = lattice(topology, {{2.5, 2.6, 2.7}}, 1 + static_cast<unsigned>(10 * time));
  draw_momenta(state, topology, 297, 1);
  state.time = time;
  return state;
}

// The rounding error of a format: half of its last digit. A float has 24 digits in base two:
// coordinates are below 3.2 nm = 32 Å, velocities below 8 nm/ps.
struct Kept {
  std::string format;
  double position;  // [nm]
  double velocity;  // [nm/ps]; 0: none are kept
  bool names;
};
const std::vector<Kept> kept = {
    {"gro", 0.5e-10, 0.5e-11, true},  {"pdb", 0.5e-4, 0, true},
    {"xyz", 0.5e-9, 0.5e-9, false},   {"xtc", 0.5e-3, 0, false},
    {"trr", 0x1p-23, 0x1p-22, false}, {"dcd", 0.1 * 0x1p-20, 0, false},
    {"h5md", 0x1p-23, 0x1p-22, true},
};

std::vector<Frame> all_frames(const std::string& path, const Frame* names = nullptr) {
  const auto reader = open_frames(path, names);
  std::vector<Frame> frames;
  for (Frame frame; reader->next(frame);) frames.push_back(frame);
  return frames;
}

std::string bytes_of(const std::string& path) {
  std::ostringstream bytes;
  bytes << std::ifstream(path, std::ios::binary).rdbuf();
  return bytes.str();
}

// The largest differences of positions and velocities [nm, nm/ps].
std::pair<double, double> differences(const Frame& a, const Frame& b) {
  double r = 0, v = 0;
  for (std::size_t i = 0; i < a.atoms.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      r = std::max(r, std::abs(a.atoms[i].r[k] - b.atoms[i].r[k]));
      v = std::max(v, std::abs(a.atoms[i].v[k] - b.atoms[i].v[k]));
    }
  return {r, v};
}

}  // namespace

TEST_CASE("every format restores what was written, to its last digit") {
  CHECK(kept.size() == writable_formats().size());
  const Folder folder;
  const Topology topology = some_molecules();
  for (const auto& [format, position, velocity, names] : kept) {
    const auto shown_format = format;
    CAPTURE(shown_format);
    const std::string path = folder / ("a." + format);
    {
      const auto writer = create_frames(path, topology);
      for (const double time : {0.5, 1.0, 1.5}) writer->write(some_state(topology, time));
      CHECK(writer->mark().frames == 3);
    }
    const std::vector<Frame> frames = all_frames(path);
    REQUIRE(frames.size() == 3);
    for (std::size_t n = 0; n < 3; ++n) {
      const Frame truth =
          frame_of(some_state(topology, 0.5 * static_cast<double>(n + 1)), topology);
      const Frame& frame = frames[n];
      REQUIRE(frame.atoms.size() == truth.atoms.size());
      CHECK(frame.has_velocities == (velocity > 0));
      // The time of DCD is a multiple of a float; others keep the decimals of 0.5.
      CHECK(std::abs(frame.time - truth.time) <= (format == "dcd" ? 3e-7 : 0));
      CHECK(norm(frame.box.edge - truth.box.edge) < 3e-7);
      const auto [r, v] = differences(frame, truth);
      // Decimal digits are rounded once more, to the nearest double.
      CHECK(r <= position * (1 + 1e-4));
      CHECK(r > position / 2);  // and the format is not more accurate than stated
      if (velocity > 0) CHECK(v <= velocity * (1 + 1e-4));
      if (!names) continue;
      for (std::size_t i = 0; i < truth.atoms.size(); ++i)
        CHECK(frame.kind(frame.atoms[i]).name == truth.kind(truth.atoms[i]).name);
    }
  }
}

TEST_CASE("appending to a file after a mark gives the same file as writing it at once") {
  const Folder folder;
  const Topology topology = some_molecules();
  for (const std::string_view format : writable_formats()) {
    CAPTURE(format);
    const std::string whole = folder / ("whole." + std::string(format));
    const std::string parts = folder / ("parts." + std::string(format));
    const auto write = [&](FrameWriter& writer, double time) {
      const std::vector<FrameNumber> energies = {{"potential_energy", "kJ mol-1", -time}};
      writer.write(some_state(topology, time), energies);
    };
    {
      const auto writer = create_frames(whole, topology);
      for (const double time : {1.0, 2.0, 3.0}) write(*writer, time);
    }
    FileMark mark;
    {
      const auto writer = create_frames(parts, topology);
      write(*writer, 1);
      mark = writer->mark();
      write(*writer, 2.5);  // is lost
      write(*writer, 3.5);
    }
    check_frames(parts, mark);
    FileMark end;
    {
      const auto writer = resume_frames(parts, topology, mark);
      write(*writer, 2);
      write(*writer, 3);
      end = writer->mark();
      CHECK(end.frames == 3);
    }
    check_frames(parts, end);  // summed in two parts
    check_frames(whole, end);  // as in one
    if (format != "h5md") CHECK((bytes_of(parts) == bytes_of(whole)));
    const auto a = all_frames(whole), b = all_frames(parts);
    REQUIRE(b.size() == 3);
    for (std::size_t n = 0; n < 3; ++n) {
      CHECK(differences(a[n], b[n]) == std::pair{0.0, 0.0});
      CHECK(a[n].time == b[n].time);
    }
    if (format == "h5md")
      check_error([&] { resume_frames(parts, topology, {9, 0}); }, {"restore the original file"});
    else
      check_error([&] { resume_frames(parts, topology, {9, 1u << 30}); }, {"data are missing"});
  }
}

TEST_CASE("a file of as many frames and bytes is known to be another one") {
  const Folder folder;
  const Topology topology = some_molecules();
  for (const std::string_view format : writable_formats()) {
    CAPTURE(format);
    const std::string mine = folder / ("mine." + std::string(format));
    const std::string other = folder / ("other." + std::string(format));
    FileMark mark;
    for (const auto& [path, second] : {std::pair{mine, 2.0}, {other, 3.0}}) {
      const auto writer = create_frames(path, topology);
      for (const double time : {1.0, second, 5.0}) {
        writer->write(some_state(topology, time));
        if (time == second && path == mine) mark = writer->mark();
      }
    }
    check_frames(mine, mark);
    check_error([&] { check_frames(other, mark); },
                {other.c_str(), "was changed: its checksum differs", "start over"});
    fs::remove(mine);
    check_error([&] { check_frames(mine, mark); },
                {mine.c_str(), "cannot be opened for appending"});
  }
}

TEST_CASE("names come from another file if a format has none") {
  const Folder folder;
  const Topology topology = some_molecules();
  const Frame names = frame_of(some_state(topology, 1), topology);
  create_frames(folder / "a.xtc", topology)->write(names);
  const auto frames = all_frames(folder / "a.xtc", &names);
  REQUIRE(frames.size() == 1);
  CHECK(frames[0].kind(frames[0].atoms[1]).name == "HW1");
  CHECK(frames[0].atoms[7].residue == 2);
  // Rounded to 0.001 nm, bodies still fit their models.
  CHECK(fit_state(frames[0], topology).deviation < 2e-3);
  Frame fewer = names;
  fewer.atoms.pop_back();
  check_error([&] { all_frames(folder / "a.xtc", &fewer); }, {"244 atoms", "243"});
}

TEST_CASE("a frame with more atoms than its format can count is refused before it is written") {
  // A record has at most 2³¹ − 1 bytes: 12 bytes per atom in TRR, 4 in DCD.
  for (const auto& [format, max_molecules] :
       {std::pair{"trr", 178'956'970}, std::pair{"dcd", 536'870'911}}) {
    const Folder folder;
    const Topology topology{
        {{read_molecule("argon"), static_cast<std::size_t>(max_molecules) + 1}}};
    const auto file = create_frames(folder / (std::string("a.") + format), topology);
    check_error([&] { file->write(State{}); }, {std::to_string(max_molecules).c_str()});
    CHECK(file->mark().frames == 0);
  }
}

TEST_CASE("the extension determines the format") {
  check_error([] { open_frames("a.grp"); },
              {"the extension of 'a.grp' is unknown", "did you mean 'gro'?"});
  check_error([] { create_frames("a", {}); }, {"the extension of 'a' is unknown"});
  check_error([] { open_frames("/none.xtc"); }, {"no readable file '/none.xtc'"});
}

TEST_CASE("extended XYZ of other programs is read, with any order of columns") {
  std::istringstream in(
      "2\n"
      "Properties=id:I:1:vel:R:3:forces:R:3:species:S:1:pos:R:3 "
      "Lattice=\"10 0.0 0 0 20 0 0 0 30\" Time=2.5 comment=\"a b\" pbc=\"T T T\"\n"
      "1 1 2 3 9 9 9 O 1.0 2.0 3.0\n"
      "2 0 0 0 9 9 9 H 4 5 6\n\n");
  const auto reader = read_frames(in, "xyz", "a.xyz");
  Frame frame;
  REQUIRE(reader->next(frame));
  CHECK(frame.box.edge.y == 2);
  CHECK(frame.time == 2.5);
  REQUIRE(frame.has_velocities);
  CHECK(norm(frame.atoms[0].v - Vec3<double>{0.1, 0.2, 0.3}) < 1e-15);
  CHECK(norm(frame.atoms[1].r - Vec3<double>{0.4, 0.5, 0.6}) < 1e-15);
  CHECK(frame.kind(frame.atoms[1]).element == "H");
  CHECK(!reader->next(frame));
}

TEST_CASE("an atom of an element is not taken for a massless site with the same first letter") {
  // Water without its massless site MW, followed by magnesium.
  const auto fitted = [](const std::string& magnesium) {
    std::istringstream in(
        "4\nLattice=\"20 0 0 0 20 0 0 0 20\"\nO 1 1 1\nH 1.7569503 1.5858823 1\n"
        "H 0.2430497 1.5858823 1\n" +
        magnesium + " 5 5 5\n");
    Frame frame;
    read_frames(in, "xyz", "a.xyz")->next(frame);
    const Molecule ion = rigid_molecule("mg", {{"MG", "Mg", {}, 24.305, 2}});
    return fit_state(frame, {{{read_molecule("tip4p"), 1}, {ion, 1}}}).state;
  };
  for (const char* magnesium : {"Mg", "MG"})
    CHECK(norm(fitted(magnesium).q[1] - Vec3<double>{0.5, 0.5, 0.5}) < 1e-12);
  check_error([&] { fitted("M"); }, {"the 4 atoms form only 1 of 2 molecules"});
  check_error([&] { fitted("C"); }, {"atom 4 is 'C' instead of site 'MG' of molecule 'mg'"});
}

TEST_CASE(
    "atoms too far from the origin for precise distances, or faster than light, are refused") {
  const auto fitted = [](const std::string& numbers) {
    std::istringstream in(
        "1\nLattice=\"20 0 0 0 20 0 0 0 20\" Properties=species:S:1:pos:R:3:velo:R:3\nAr " +
        numbers);
    Frame frame;
    read_frames(in, "xyz", "a.xyz")->next(frame);
    return fit_state(frame, {{{read_molecule("argon"), 1}}}).state;
  };
  CHECK(fitted("9e6 0 0 2e6 0 0\n").q[0].x == doctest::Approx(9e5));
  check_error(
      [&] { fitted("0 1.1e7 0 0 0 0\n"); },
      {"the distance from the origin of atom 1 ('Ar') is 1.1e+06 nm", "at most 1e+06 nm", "a.xyz"});
  check_error([&] { fitted("1e300 0 0 0 0 0\n"); }, {"at most 1e+06 nm"});
  check_error([&] { fitted("0 0 0 0 0 3e6\n"); },
              {"the speed of atom 1 ('Ar') is 3e+05 nm/ps", "at most 299792 nm/ps"});
  check_error([&] { fitted("0 0 0 0 0 1e200\n"); }, {"the speed of atom 1"});
}

TEST_CASE("a truncated or changed file gives an error or frames, nothing else") {
  const Folder folder;
  const Topology topology{
      {{read_molecule("tip4p"), 3}}};  // more atoms than XTC stores uncompressed
  for (const std::string_view format : writable_formats()) {
    CAPTURE(format);
    const std::string path = folder / ("a." + std::string(format));
    create_frames(path, topology)->write(some_state(topology, 1));
    const std::string whole = bytes_of(path);
    std::size_t errors = 0, read = 0;
    const auto attempt = [&](const std::string& bytes) {
      std::istringstream in(bytes);
      try {
        const auto reader = read_frames(in, format, "a");
        for (Frame frame; reader->next(frame);) ++read;
      } catch (const Error& e) {
        CHECK(!e.where().empty());
        ++errors;
      }
    };
    attempt(whole);
    CHECK(read == 1);
    const std::size_t stride = std::max<std::size_t>(1, whole.size() / 300);
    for (std::size_t k = 0; k < whole.size(); k += stride) {
      attempt(whole.substr(0, k));
      if (format == "h5md") continue;  // some changes cause infinite loops in the HDF5 library
      for (const char change : {'\x01', '\x80', '\xff'}) {
        std::string bytes = whole;
        bytes[k] = static_cast<char>(bytes[k] ^ change);
        attempt(bytes);
      }
    }
    CHECK(errors > 0);
  }
}

TEST_CASE("keys of an XYZ comment that occur twice are refused") {
  const std::string atom = "O 1 2 3\n", box = "Lattice=\"10 0 0 0 20 0 0 0 30\"";
  const auto read = [&](const std::string& comment) {
    std::istringstream in("1\n" + comment + "\n" + atom);
    Frame frame;
    return read_frames(in, "xyz", "a.xyz")->next(frame);
  };
  CHECK(read(box + " Time=1 note=a note=b"));
  check_error([&] { read(box + " lattice=\"11 0 0 0 20 0 0 0 30\""); },
              {"Lattice twice", "delete the wrong entry", "a.xyz:2"});
  check_error([&] { read(box + " Time=1 time=2"); }, {"Time twice"});
}
