// SPDX-License-Identifier: MIT
#include "base/threads.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

#include "base/control_groups.hpp"
#include "base/from_chars.hpp"
#include "polhode/base/error.hpp"

#ifdef __linux__
#include <sched.h>
#endif

namespace polhode {
namespace {

namespace fs = std::filesystem;

/// Number of cores in the affinity mask.
int bound_cores() {
#ifdef __linux__
  for (int cores = 1024; cores <= 1 << 20; cores *= 2) {  // until the set of the kernel fits
    cpu_set_t* set = CPU_ALLOC(static_cast<std::size_t>(cores));
    const std::size_t bytes = CPU_ALLOC_SIZE(static_cast<std::size_t>(cores));
    const bool known = sched_getaffinity(0, bytes, set) == 0;
    const int count = known ? CPU_COUNT_S(bytes, set) : 0;
    CPU_FREE(set);
    if (known) return std::max(1, count);
  }
#endif
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// The first line of a file; empty if there is none.
std::string first_line(const fs::path& file) {
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  return line;
}

/// The quota divided by the period, in cores; "max" and -1 mean no limit.
std::optional<int> cores(const std::string& quota, const std::string& period) {
  const double q = std::atof(quota.c_str()), p = std::atof(period.c_str());
  if (!(q > 0) || !(p > 0)) return std::nullopt;
  return static_cast<int>(std::clamp(std::ceil(q / p), 1.0, 1e6));
}

std::optional<int> smaller(std::optional<int> a, std::optional<int> b) {
  return a && b ? std::min(a, b) : a ? a : b;
}

/// The CPU limit of a control group, of version 1 or 2.
std::optional<int> bound_of(const fs::path& group) {
  std::istringstream words(first_line(group / "cpu.max"));
  std::string quota, period;
  words >> quota >> period;
  return smaller(cores(quota, period), cores(first_line(group / "cpu.cfs_quota_us"),
                                             first_line(group / "cpu.cfs_period_us")));
}

/// Parses and checks a number of threads.
int parse_thread_count(const std::string& text, const std::string& place) {
  const int allowed = allowed_threads();
  const int n = parsed_number<int>(text).value_or(0);
  if (n >= 1 && n <= allowed) return n;
  throw Error(fmt::format("threads = '{}' must be a whole number from 1 to {}, the number of cores "
                          "that this process may use",
                          text, allowed),
              place);
}

}  // namespace

std::optional<int> group_bandwidth(const std::string& membership, const fs::path& mount) {
  std::optional<int> bound;
  for (const fs::path& group : control_groups("cpu", membership, mount))
    bound = smaller(bound, bound_of(group));
  return bound;
}

int allowed_threads() {
  const std::optional<int> bandwidth =
      group_bandwidth(control_group_membership(), "/sys/fs/cgroup");
  return std::min(bound_cores(), bandwidth.value_or(bound_cores()));
}

int requested_threads(const std::string& option, const std::string& place) {
  if (!option.empty()) return parse_thread_count(option, place);
  const char* const variable = std::getenv("POLHODE_THREADS");
  if (variable != nullptr && *variable != '\0')
    return parse_thread_count(variable, "POLHODE_THREADS");
  return allowed_threads();
}

int requested_threads(std::optional<int> option) {
  return requested_threads(option ? std::to_string(*option) : std::string());
}

}  // namespace polhode
