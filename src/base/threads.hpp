// SPDX-License-Identifier: MIT
// How many threads a process may use, and the number that the user requested.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace polhode {

/// The number of cores this process may use, at least 1: those of its affinity mask, limited to the
/// CPU bandwidth (rounded up) of its control groups.
/// @source  sched_setaffinity(2); cgroups(7); cpu.max of version 2, cpu.cfs_quota_us of version 1
int allowed_threads();

/// The bandwidth of control groups in cores, rounded up; nothing if there is no limit.
/// @param membership  contents of /proc/self/cgroup
/// @param mount       where the control groups are mounted
std::optional<int> group_bandwidth(const std::string& membership,
                                   const std::filesystem::path& mount);

/// The option if given, else the environment variable POLHODE_THREADS, else all threads allowed.
/// @throws Error  if the number is not an integer from 1 to allowed_threads()
int requested_threads(std::optional<int> option);

/// The same for the option as it was typed; empty if not given.
/// @param place  of the option, for errors: "--threads"
int requested_threads(const std::string& option, const std::string& place = "threads");

}  // namespace polhode
