// SPDX-License-Identifier: MIT
#include "base/memory.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "../errors.hpp"
#include "../folder.hpp"
#include "forces/pairs/neighbours.hpp"
#include "model/cell_list.hpp"
#include "polhode/io/topology/molecule_file.hpp"
#include "polhode/measure/radial_distribution.hpp"

using namespace polhode;

TEST_CASE("requests beyond the memory are refused with their amount and a remedy") {
  const double limit = memory_limit();
  CHECK(limit > 1e8);  // less than any computer on which this builds
  CHECK(limit < 1e16);
  CHECK_NOTHROW(require_memory(0.9 * limit, "things", "use fewer"));
  check_error([&] { require_memory(1.1 * limit, "5 things", "use fewer of them"); },
              {"5 things need at least", "GB of memory", "may use", "use fewer of them"});
  check_error([] { require_memory(1e300, "things", "use fewer"); }, {"1e+291 GB"});
}

TEST_CASE("the memory limit is the lowest limit of the control groups of the process") {
  const Folder folder;
  const auto write = [&](const std::string& name, const std::string& text) {
    const std::filesystem::path path = folder / name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path) << text << '\n';
  };
  const auto limit = [&](const std::string& groups) {
    return group_memory_limit(groups, folder.path);
  };
  const std::string version2 = "0::/user/job/step\n";
  CHECK(std::isinf(limit("")));
  CHECK(std::isinf(limit(version2)));
  write("user/job/step/memory.max", "max");
  CHECK(std::isinf(limit(version2)));
  write("user/job/memory.max", "3000000000");
  write("user/other/memory.max", "1000");
  CHECK(limit(version2) == 3e9);
  write("user/memory.max", "4000000000");
  CHECK(limit(version2) == 3e9);
  write("user/job/step/memory.max", "2000000000");
  CHECK(limit(version2) == 2e9);
  write("memory.max", "1000000000");
  CHECK(limit(version2) == 1e9);
  CHECK(limit("0::/\n") == 1e9);

  const std::string version1 = "12:cpu,cpuacct:/slow\n4:blkio,memory:/batch/job\n0::/\n";
  write("blkio,memory/batch/memory.limit_in_bytes", "600000000");
  CHECK(limit(version1) == 6e8);
  write("memory/batch/job/memory.limit_in_bytes", "500000000");
  write("memory/slow/memory.limit_in_bytes", "1000");
  CHECK(limit(version1) == 5e8);
  CHECK(std::isinf(limit("without colons\n:\n4:memory:/absent\n")));
}

TEST_CASE("counts beyond what the list can index are refused, also if their sum overflows") {
  const Molecule argon = read_molecule("argon");
  CHECK_NOTHROW(check_count({{{argon, 60'000'000}}}));
  for (const std::size_t count : {std::size_t{70'000'000}, std::size_t{1} << 40, ~std::size_t{0}})
    check_error(
        [&] {
          check_count({{{argon, count}}});
        },
        {"molecules are more than the neighbour list can index (67108863)", "use fewer"});
  check_error([&] { check_count({{{argon, ~std::size_t{0}}, {argon, 2}}}); }, {"use fewer"});
}

TEST_CASE("histograms beyond the memory are refused") {
  const Topology argon{{{read_molecule("argon"), 8}}};
  check_error(
      [&] {
        RadialDistribution(argon, {site_pairs(argon), 1.0, 1e-20});
      },
      {"histograms of 1e+20 bins", "use wider bins"});
}

// Cells have the required width if there are few, otherwise the width that limits their number,
// within a quarter.
TEST_CASE("cells of a large box are as wide as their number allows") {
  const auto cells = [](const Box& box, double width) {
    double n = 1;
    for (std::size_t k = 0; k < 3; ++k) n *= std::max(1.0, std::floor(box.edge[k] / width));
    return n;
  };
  for (const Vec3<double>& edge :
       {Vec3<double>{3, 3, 3}, {400, 300, 500}, {8000, 8000, 8000}, {1, 1, 8000}, {0.3, 900, 900}})
    for (const double max_cells : {1.0, 64.0, 1e5}) {
      const Box box{edge};
      const double width = cell_width(box, 0.5, max_cells);
      CHECK(width >= 0.5);
      CHECK(cells(box, width) <= max_cells);
      if (width > 0.5) CHECK(cells(box, width / 1.25) > max_cells);
    }
}
