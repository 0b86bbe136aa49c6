// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <span>
#include <sstream>
#include <vector>

#include "../errors.hpp"
#include "../folder.hpp"
#include "io/coordinates/gro.hpp"
#include "io/files/checksum.hpp"
#include "io/files/write_file.hpp"
#include "io/formats/format.hpp"
#include "model/initial_state.hpp"
#include "polhode/io/files/table_file.hpp"
#include "polhode/io/topology/molecule_file.hpp"

using namespace polhode;
namespace fs = std::filesystem;

namespace {

std::string text_of(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

}  // namespace

TEST_CASE("an extended XYZ frame is in angstrom") {
  Frame frame;
  frame.box = {{1, 2, 3}};
  frame.time = 0.5;
  frame.has_velocities = true;
  frame.kinds = {{"SOL", "OW", "O"}, {"SOL", "MW", ""}};
  frame.atoms = {{.kind = 0, .r = {0.1, -0.2, 0.3}, .v = {1, 0, -1}}, {.kind = 1, .r = {0, 0, 0}}};
  std::stringstream in;
  append_xyz(in, view_of(frame), 0);
  std::string count, comment, species;
  std::getline(in, count);
  std::getline(in, comment);
  CHECK(count == "2");
  CHECK(comment ==
        "Lattice=\"10 0 0 0 20 0 0 0 30\" Properties=species:S:1:pos:R:3:velo:R:3 Time=0.500000 "
        "pbc=\"T T T\"");
  double x, y, z, u, v, w;
  in >> species >> x >> y >> z >> u >> v >> w;
  CHECK(species == "O");
  // Decimal fractions of eight digits: the nearest double, so they are equal.
  CHECK(Vec3<double>{x, y, z} == Vec3<double>{1, -2, 3});
  CHECK(Vec3<double>{u, v, w} == Vec3<double>{10, 0, -10});
  in >> species;
  CHECK(species == "X");
}

TEST_CASE("writing states equals writing their frames") {
  // More than one piece of text, two kinds of molecules, numbers of atoms beyond five digits.
  const Topology topology{{{read_molecule("tip4p"), 26000}, {read_molecule("argon"), 1000}}};
  State state = lattice(topology, {{9, 10, 11}}, 1);
  draw_momenta(state, topology, 297, 1);
  state.q.add(5, {40, -30, 20});
  state.time = 1.25;
  const Frame frame = frame_of(state, topology);
  CHECK(frame.atoms.size() == 105000);
  std::ostringstream gro, gro_of_frame;
  std::stringstream xyz, xyz_of_frame;
  write_gro(gro, state, topology);
  write_gro(gro_of_frame, frame);
  append_xyz(xyz, view_of(state, topology), 0);
  append_xyz(xyz_of_frame, view_of(frame), 0);
  CHECK((gro.str() == gro_of_frame.str()));
  CHECK((xyz.str() == xyz_of_frame.str()));
  const auto lines = [](const std::string& text) { return std::ranges::count(text, '\n'); };
  CHECK(lines(gro.str()) == 105003);
  CHECK(lines(xyz.str()) == 105002);
}

TEST_CASE("numbers of fixed width equal those of printf") {
  std::vector<double> numbers{0.0,
                              -0.0,
                              0.5,
                              1.5,
                              -2.5,
                              0.125,
                              0.0005,
                              1e-12,
                              -1e-12,
                              31.0497,
                              99999.999999,
                              1e300,
                              -1e22,
                              900719.9254740992,
                              std::numeric_limits<double>::infinity()};
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> below(-12, 12);
  for (int k = 0; k < 500; ++k) {
    numbers.push_back(below(random));
    numbers.push_back(std::ldexp(std::nearbyint(4096 * below(random)), -13));  // many are ties
    numbers.push_back(std::nearbyint(1e3 * below(random)) / 1e3 + 0.5e-3);     // nearly ties
  }
  for (const double x : numbers)
    for (const int decimals : {0, 2, 3, 10}) {
      Frame frame;
      frame.title = "t";
      frame.box = {{1, 1, 1}};
      frame.kinds = {{"R", "A", ""}};
      frame.atoms = {{.residue = 1, .r = {x, 0, 0}}};
      std::ostringstream out;
      write_gro(out, frame, decimals);
      std::vector<char> number(400);
      std::snprintf(number.data(), number.size(), "%*.*f", decimals + 5, decimals, x);
      CAPTURE(x);
      const std::string head = "t\n    1\n    1R        A    1", text = out.str();
      if (std::abs(x) < 9999) {
        CHECK(text.starts_with(head + number.data()));
      } else {  // columns widen: the number alone
        CHECK(text.starts_with(head));
        const std::string digits(
            std::string_view(number.data())
                .substr(std::string_view(number.data()).find_first_not_of(' ')));
        CHECK(text.substr(text.find_first_not_of(' ', head.size())).starts_with(digits + " "));
      }
    }
}

TEST_CASE("the hash of a text is FNV-1a") {
  // Test vectors of the authors of FNV (Noll).
  CHECK(text_hash("") == "cbf29ce484222325");
  CHECK(text_hash("a") == "af63dc4c8601ec8c");
  CHECK(text_hash("foobar") == "85944171f73967e8");
}

TEST_CASE("a table has all digits and begins with its columns and the command that made it") {
  const double third = 1.0 / 3;
  const Table table{{{"time", "ps"}, {"R", "%"}},
                    {{0.0, third}, {0.1, std::numeric_limits<double>::quiet_NaN()}}};
  std::ostringstream out;
  write_csv(out, table, {"1.2.3", "polhode run\nx", "foobar", "avx2", 7});
  std::istringstream in(out.str());
  std::string line;
  for (const char* expected :
       {"time [ps],R [%]", "# polhode 1.2.3", "# command: polhode run\\x0ax",
        "# config hash: 85944171f73967e8", "# instruction set: avx2", "# seed: 7"}) {
    std::getline(in, line);
    CHECK(line == expected);
  }
  std::getline(in, line);
  CHECK(std::stod(line.substr(line.find(',') + 1)) == third);
  std::getline(in, line);
  CHECK(line == "0.1,");
  std::ostringstream named;
  write_csv(named, {{{"scheme", ""}, {"cost", "1/ps"}}, {{"hoa2", 500.0}, {"A(1), B(1)", 1.0}}},
            {});
  CHECK(named.str().starts_with("scheme,cost [1/ps]\n# "));
  CHECK(named.str().ends_with("\nhoa2,500\n\"A(1), B(1)\",1\n"));
}

TEST_CASE("a growing table is read back and extended") {
  const Folder folder;
  const std::string file = folder / "a.csv";
  const std::vector<Table::Column> columns = {{"time", "ps"}, {"R", "%"}};
  const Provenance provenance{"1.2.3", "polhode run", "foobar", "avx2", 7};
  const std::vector<std::vector<double>> rows = {{0, 1.0 / 3}, {1e-300, -2.5e7}, {0.1, -0.0}};
  TableMark mark;
  {
    GrowingTable table(file, columns, provenance);
    table.add(rows[0]);
    table.add(rows[1]);
    mark = table.mark();
    table.add(std::vector<double>{7, 8});
  }
  {
    GrowingTable table(file, mark);
    CHECK(table.mark().checksum == mark.checksum);
    table.add(rows[2]);
    const TableMark end = table.mark();
    CHECK(end.bytes == fs::file_size(file));
    CHECK(end.checksum == file_crc64(file, 0, end.bytes));
  }
  std::vector<std::vector<double>> read;
  const auto take = [&](std::span<const double> row) { read.emplace_back(row.begin(), row.end()); };
  each_row(file, fs::file_size(file), columns, take);
  CHECK(read == rows);
  std::ostringstream whole;
  write_csv(whole, {columns, {{0.0, 1.0 / 3}, {1e-300, -2.5e7}, {0.1, -0.0}}}, provenance);
  CHECK(text_of(file) == whole.str());

  read.clear();
  each_row(file, mark.bytes, columns, take);
  CHECK(read.size() == 2);
  check_error([&] { each_row(file, mark.bytes - 1, columns, take); }, {"a.csv", "end of line"});
  check_error([&] { each_row(file, mark.bytes + 1000, columns, take); }, {"a.csv", "bytes"});
  check_error(
      [&] {
        GrowingTable(file, TableMark{mark.bytes + 1000, 0});
      },
      {"a.csv", "bytes", "start over"});
  check_error(
      [&] {
        each_row(file, mark.bytes, {{"time", "fs"}}, take);
      },
      {"a.csv:1", "time [fs]"});
  write_file(file, [](std::ostream& out) { out << "time [ps],R [%]\n1,2\n1,x\n1,2,3\n"; });
  check_error([&] { each_row(file, 24, columns, take); }, {"a.csv:3", "1,x"});
  write_file(file, [](std::ostream& out) { out << "time [ps],R [%]\n1,2,3\n"; });
  check_error([&] { each_row(file, 22, columns, take); }, {"a.csv:2", "3 numbers", "2"});
}

TEST_CASE("existing outputs are not overwritten unless that is requested") {
  const Folder folder;
  const std::string file = folder / "a.csv";
  refuse_existing(file, false);
  write_file(file, [](std::ostream& out) { out << "first"; });
  CHECK(text_of(file) == "first");
  check_error([&] { refuse_existing(file, false); }, {"a.csv' exists", "another output"});
  refuse_existing(file, true);
  check_error([&] { refuse_existing(folder / "none/a.csv", false); }, {"there is no folder"});
  check_error([&] { refuse_existing(folder.path.string(), true); }, {"is a folder"});
}

TEST_CASE("a file is written completely or not at all") {
  const Folder folder;
  const std::string file = folder / "a.csv";
  write_file(file, [](std::ostream& out) { out << "old"; });
  CHECK_THROWS(write_file(file, [](std::ostream& out) {
    out << "half";
    throw std::runtime_error("stop");
  }));
  CHECK(text_of(file) == "old");
  CHECK_THROWS_AS(write_file(folder / "none/a.csv", [](std::ostream&) {}), RunError);
  // Other files are not touched, and nothing but the file itself remains.
  const auto touched = [&](const char* name) { return text_of(folder / name) != "mine"; };
  for (const char* name : {"b.csv.part", "unfinished-b.csv", "b.csv.old"})
    std::ofstream(folder / name) << "mine";
  write_file(folder / "b.csv", [](std::ostream& out) { out << "1"; });
  write_file(
      folder / "b.csv", [](std::ostream& out) { out << "2"; }, folder / "b.csv.kept");
  CHECK(text_of(folder / "b.csv") == "2");
  CHECK(text_of(folder / "b.csv.kept") == "1");
  for (const char* name : {"b.csv.part", "unfinished-b.csv", "b.csv.old"}) CHECK(!touched(name));
  for (const char* name : {"b.csv.part", "unfinished-b.csv", "b.csv.old", "b.csv", "b.csv.kept"})
    fs::remove(folder / name);
  CHECK(std::distance(fs::directory_iterator(folder.path), fs::directory_iterator()) == 1);
}
