// SPDX-License-Identifier: MIT
// The identity of a run: a checkpoint of another one is not resumed.
#include <doctest/doctest.h>
#include <fmt/core.h>

#include <cmath>
#include <fstream>

#include "../folder.hpp"
#include "run/simulation/files/checkpoint.hpp"
#include "run/simulation/files/identity.hpp"

using namespace polhode;

namespace {

/// A run file of two beads, with the file of their law.
std::string write_run(const Folder& folder, const std::string& law, const std::string& pair) {
  std::ofstream(folder / "bead.toml") << R"(name = "bead"
description = "a bead"
source = "jager2009"
[[site]]
name = "B"
element = "Ar"
position = "0 0 0 nm"
mass = "40 u"
)" << law;
  const std::string file = folder / "run.toml";
  std::ofstream(file) << R"([system]
molecules = [{ model = "bead.toml", count = 2 }]
box = "3 nm"
temperature = "100 K"
[forces]
cutoff = "1 nm"
)" << pair;
  return file;
}

/// Energies that fall by 1/e every eight distances, from 0.2 nm on.
void write_table(const std::string& file, double spacing) {
  std::ofstream out(file);
  for (int k = 0; k <= 80; ++k) {
    const double u = std::exp(-k / 8.0);
    out << fmt::format("{:.12g} {} {}\n", 0.2 + k * spacing, u, u / 8 / spacing);
  }
}

std::string identity_of(const std::string& file) {
  const Config config = read_config(file);
  return run_identity(config, build_system(config));
}

}  // namespace

TEST_CASE("a run is another one if the table of a law was changed, for sites and for pairs") {
  const Folder folder;
  const std::string tabulated = "law = \"tabulated\"\ntable = \"u.txt\"\n";
  write_table(folder / "u.txt", 0.02);
  std::string run;
  SUBCASE("of a site") { run = write_run(folder, tabulated, ""); }
  SUBCASE("of a pair") {
    run = write_run(folder, "sigma = \"0.3 nm\"\nepsilon = \"1 kJ/mol\"\n",
                    fmt::format("[[pair]]\nsites = [\"bead.B\", \"bead.B\"]\n{}", tabulated));
  }
  const std::string before = identity_of(run);
  CHECK(same_run(before, identity_of(run)));
  write_table(folder / "u.txt", 0.021);  // the same energies
  CHECK_FALSE(same_run(before, identity_of(run)));
}
