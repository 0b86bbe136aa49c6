// SPDX-License-Identifier: MIT
// Number of available and requested threads.
#include "base/threads.hpp"

#include <doctest/doctest.h>
#include <fmt/core.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>

#include "unit/errors.hpp"

using namespace polhode;

namespace {

namespace fs = std::filesystem;

/// A folder of control groups, removed at the end.
struct Groups {
  fs::path root = fs::temp_directory_path() / ("polhode-threads-test-" + std::to_string(getpid()));
  Groups() { fs::remove_all(root); }
  ~Groups() { fs::remove_all(root); }
  void write(const fs::path& file, const std::string& line) const {
    fs::create_directories((root / file).parent_path());
    std::ofstream(root / file) << line << "\n";
  }
};

}  // namespace

TEST_CASE("the CPU limit of control groups is the minimum up to the root, rounded up") {
  const Groups groups;
  groups.write("a/cpu.max", "250000 100000");
  groups.write("a/b/cpu.max", "max 100000");
  groups.write("a/c/cpu.max", "50000 100000");
  CHECK(group_bandwidth("0::/a\n", groups.root) == 3);
  CHECK(group_bandwidth("0::/a/b\n", groups.root) == 3);
  CHECK(group_bandwidth("0::/a/c\n", groups.root) == 1);
  CHECK(group_bandwidth("0::/a/not/seen\n", groups.root) == 3);
  CHECK(group_bandwidth("0::/\n", groups.root) == std::nullopt);
  CHECK(group_bandwidth("", groups.root) == std::nullopt);
  CHECK(group_bandwidth("nonsense\n0:\n", groups.root) == std::nullopt);
}

TEST_CASE("version 1 of control groups is read as well") {
  const Groups groups;
  groups.write("cpu,cpuacct/a/cpu.cfs_quota_us", "400000");
  groups.write("cpu,cpuacct/a/cpu.cfs_period_us", "100000");
  groups.write("cpu,cpuacct/b/cpu.cfs_quota_us", "-1");
  groups.write("cpu,cpuacct/b/cpu.cfs_period_us", "100000");
  groups.write("cpu/cpu.cfs_quota_us", "150000");
  groups.write("cpu/cpu.cfs_period_us", "100000");
  CHECK(group_bandwidth("5:memory:/a\n4:cpu,cpuacct:/a\n", groups.root) == 2);
  fs::remove_all(groups.root / "cpu");
  CHECK(group_bandwidth("5:memory:/a\n4:cpu,cpuacct:/a\n", groups.root) == 4);
  CHECK(group_bandwidth("4:cpu,cpuacct:/b\n", groups.root) == std::nullopt);
  CHECK(group_bandwidth("4:cpuset:/a\n", groups.root) == std::nullopt);
}

TEST_CASE("the number of threads is that of the option, else of the environment, else all cores") {
  const int all = allowed_threads();
  CHECK(all >= 1);
  const std::string bound = fmt::format("1 to {}", all);
  unsetenv("POLHODE_THREADS");
  CHECK(requested_threads(std::nullopt) == all);
  CHECK(requested_threads(1) == 1);
  setenv("POLHODE_THREADS", "1", 1);
  CHECK(requested_threads(std::nullopt) == 1);
  CHECK(requested_threads(all) == all);
  for (const int n : {0, -3, all + 1})
    check_error([&] { requested_threads(n); },
                {fmt::format("'{}'", n).c_str(), bound.c_str(), "core", "threads"});
  const std::string too_many = std::to_string(all + 1);
  for (const char* text : {"0", "-1", "two", "1.5", "1 2", "99999999999", too_many.c_str()}) {
    setenv("POLHODE_THREADS", text, 1);
    const std::string quoted = fmt::format("'{}'", text);
    check_error([&] { requested_threads(std::nullopt); },
                {quoted.c_str(), bound.c_str(), "core", "POLHODE_THREADS"});
  }
  check_error([] { requested_threads("two"); }, {"'two'", bound.c_str(), "threads"});
  check_error([] { requested_threads("two", "--threads"); }, {"--threads"});
  CHECK(requested_threads("1") == 1);
  setenv("POLHODE_THREADS", "", 1);
  CHECK(requested_threads("") == all);
  CHECK(requested_threads(std::nullopt) == all);
  unsetenv("POLHODE_THREADS");
}
