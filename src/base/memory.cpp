// SPDX-License-Identifier: MIT
#include "base/memory.hpp"

#include <fmt/core.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>

#include "base/control_groups.hpp"
#include "polhode/base/error.hpp"

namespace polhode {
namespace {

/// The number in a file; infinite if there is no such file, or if the file contains a word, which
/// means that there is no limit.
double limit_in(const std::filesystem::path& path) {
  double limit = 0;
  std::ifstream file(path);
  return file >> limit && limit > 0 ? limit : std::numeric_limits<double>::infinity();
}

}  // namespace

double group_memory_limit(const std::string& membership, const std::filesystem::path& mount) {
  double limit = std::numeric_limits<double>::infinity();
  for (const std::filesystem::path& group : control_groups("memory", membership, mount))
    for (const char* file : {"memory.max", "memory.limit_in_bytes"})  // of versions 2 and 1
      limit = std::min(limit, limit_in(group / file));
  return limit;
}

double memory_limit() {
  double limit =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
  for (const auto resource : {RLIMIT_AS, RLIMIT_DATA}) {
    rlimit own{};
    if (getrlimit(resource, &own) == 0 && own.rlim_cur != RLIM_INFINITY)
      limit = std::min(limit, static_cast<double>(own.rlim_cur));
  }
  return std::min(limit, group_memory_limit(control_group_membership(), "/sys/fs/cgroup"));
}

void require_memory(double bytes, const std::string& what, const std::string& remedy) {
  const double limit = memory_limit();
  if (bytes <= limit) return;
  constexpr double GB = 1e9;
  throw Error(fmt::format(
      "{} need at least {:.3g} GB of memory, but this process may use only {:.3g} GB: {}", what,
      bytes / GB, limit / GB, remedy));
}

}  // namespace polhode
