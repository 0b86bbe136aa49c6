// SPDX-License-Identifier: MIT
#include "base/memory.hpp"

#include <fmt/core.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>

#include "polhode/base/error.hpp"

namespace polhode {
namespace {

/// The number in a file; infinite if there is no such file, or if the file contains a word, which
/// means that there is no limit.
double limit_in(const std::string& path) {
  double limit = 0;
  std::ifstream file(path);
  return file >> limit && limit > 0 ? limit : std::numeric_limits<double>::infinity();
}

/// The lowest limit of a group and of the groups that contain it, "/a/b", "/a" and "".
double limit_of_groups(const std::string& root, std::string group, const char* file) {
  double limit = limit_in(root + '/' + file);
  while (!group.empty()) {
    limit = std::min(limit, limit_in(root + group + '/' + file));
    group.resize(std::min(group.rfind('/'), group.size() - 1));
  }
  return limit;
}

/// Whether a list such as "cpu,memory" has the controller of memory.
bool has_memory(const std::string& controllers) {
  return (',' + controllers + ',').find(",memory,") != std::string::npos;
}

}  // namespace

double group_memory_limit(const std::string& groups, const std::string& root) {
  double limit = limit_in(root + "/memory.max");
  std::ifstream file(groups);
  for (std::string line; std::getline(file, line);) {
    // "0::/group" in version 2, "4:memory:/group" in version 1
    const auto first = line.find(':'), second = line.find(':', first + 1);
    if (first == line.npos || second == line.npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1),
                      group = line.substr(second + 1);
    if (controllers.empty())
      limit = std::min(limit, limit_of_groups(root, group, "memory.max"));
    else if (has_memory(controllers))
      limit = std::min(limit, limit_of_groups(root + "/memory", group, "memory.limit_in_bytes"));
  }
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
  return std::min(limit, group_memory_limit("/proc/self/cgroup", "/sys/fs/cgroup"));
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
