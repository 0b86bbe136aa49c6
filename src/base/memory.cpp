// SPDX-License-Identifier: MIT
#include "base/memory.hpp"

#include <fmt/core.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

#include "polhode/base/error.hpp"

namespace polhode {

double memory_limit() {
  double limit =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
  for (const auto resource : {RLIMIT_AS, RLIMIT_DATA}) {
    rlimit own{};
    if (getrlimit(resource, &own) == 0 && own.rlim_cur != RLIM_INFINITY)
      limit = std::min(limit, static_cast<double>(own.rlim_cur));
  }
  // The memory limit of a control group. If there is no limit, the file of the limit contains a
  // word instead of a number.
  double group = 0;
  if (std::ifstream file("/sys/fs/cgroup/memory.max"); file >> group && group > 0)
    limit = std::min(limit, group);
  return limit;
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
