// SPDX-License-Identifier: MIT
#include "run/study/run_record.hpp"

#include <doctest/doctest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "../errors.hpp"
#include "io/files/write_file.hpp"

using namespace polhode;

TEST_CASE("the record of a study has the R of rounding, and records without it can be read") {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("polhode-rounding-" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  const std::string path = (folder / "runs.csv").string();
  const Provenance provenance{"0", "", "of this test", "", 1};
  StudyRun run{.scheme = "hoa2", .step = 0.002, .start = 1, .ratio = 3e-5, .temperature = 297};
  run.rounding = 2.5e-5;
  run.near_weight = 0.25;
  run.configurational = {301, 302, 303, 304};
  StudyRecord(path, provenance, false).add(run);
  {
    const StudyRecord again(path, provenance, false);
    REQUIRE(again.known().size() == 1);
    CHECK(again.known()[0].rounding == 2.5e-5);
    CHECK(again.known()[0].near_weight == 0.25);
    CHECK(again.known()[0].configurational == run.configurational);
    CHECK(again.known()[0].temperature == 297);
  }
  std::vector<std::string> lines;
  {
    std::ifstream in(path);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
  }
  for (const int fields : {15, 14, 10, 9}) {  // of older versions
    std::ofstream old(path);
    for (std::string line : lines) {
      for (int field = 19; line[0] != '#' && field > fields; --field) line.resize(line.rfind(';'));
      old << line << '\n';
    }
    old.close();
    const StudyRecord again(path, provenance, false);
    REQUIRE(again.known().size() == 1);
    CHECK(again.known()[0].near_weight == (fields < 15 ? 0 : 0.25));
    CHECK(!again.known()[0].configurational);
    CHECK(again.known()[0].rounding == (fields == 9 ? 0 : 2.5e-5));
    CHECK(again.known()[0].temperature == 297);
  }
  std::filesystem::remove_all(folder);
}

TEST_CASE("a record of a study is read completely, or refused with the line") {
  const Provenance provenance{"0", "", "of this test", "", 1};
  const std::string head = "# study " + text_hash(provenance.config) +
                           "\n# polhode 0, instruction set scalar\n"
                           "scheme;step [ps];start;stable;R;drift;total;potential;temperature\n";
  const std::string line = "hoa2;0.002;1;1;3e-05;-0.5;0.006;200;297\n";
  const auto read = [&](const std::string& lines) {
    std::istringstream in(head + lines);
    return StudyRecord::read(in, "runs.csv", &provenance);
  };
  REQUIRE(read(line).size() == 1);
  CHECK(read(line)[0].drift == -0.5);

  // A last line without its line end may have lost digits, and a power failure may leave zeros.
  CHECK(read(line + "hoa2;0.004;1;1;3e-05;-0.5;0.006;200;29").size() == 1);
  CHECK(read(line + std::string(512, '\0')).size() == 1);
  // The numbers of a run that blew up are ignored.
  CHECK(!read("hoa2;0.002;1;0;nan;nan;nan;nan;nan\n")[0].stable);

  const auto refused = [&](const char* from, const char* to, const char* what) {
    check_error([&] { read(line + replaced(line, from, to)); }, {"runs.csv:5", what, "start over"});
  };
  refused("297", "nan", "'nan' for the temperature, which must be a finite number");
  refused("3e-05", "inf", "'inf' for the R, which must be a finite number");
  refused("200", "2OO", "found '2OO' for");
  refused("0.002", "1e999", "found '1e999' for the step");
  refused("200", "-200", "the fluctuation of the potential energy is -200");
  refused(";1;1", ";-1;1", "found '-1' for the start, which must be a whole number of 0 or more");
  refused(";1;1", ";1.5;1", "found '1.5' for the start");
  refused(";1;1", ";99999999999;1", "found '99999999999' for the start");
  refused(";1;1", ";1;yes", "found 'yes' for 'stable', which must be 1 or 0");
  refused(";297", "", "8 fields; it must have 9");
  refused(";297", ";297;1", "10 fields; it must have 9");
  refused("\n", "\n", "the same scheme, step and initial configuration as");
  check_error([&] { read("scheme;step\n"); }, {"runs.csv:4", "2 columns", "start over"});
  check_error([&] { read(line + "\x01\n"); }, {"runs.csv:5", "0x01"});
  const Provenance empty;
  std::istringstream other("# study 0\n" + line), no_head("# study " + text_hash("") + "\n" + line);
  check_error([&] { StudyRecord::read(other, "runs.csv", &provenance); },
              {"runs.csv:1", "another study", "start over"});
  check_error([&] { StudyRecord::read(no_head, "runs.csv", &empty); },
              {"runs.csv:2", "with the column names", "start over"});
}
