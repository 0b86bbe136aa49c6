// SPDX-License-Identifier: MIT
// The number of threads that a process may use, and the number that the user requested.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace polhode {

/// The number of cores that this process may use, at least 1. The result is the number of cores in
/// the affinity mask, or the CPU bandwidth of the control groups (rounded up) if this is lower.
/// @source  sched_setaffinity(2); cgroups(7); cpu.max of version 2, cpu.cfs_quota_us of version 1
int allowed_threads();

/// The CPU bandwidth of control groups in cores, rounded up; empty if there is no limit.
/// @param membership  contents of /proc/self/cgroup
/// @param mount       folder where the control groups are mounted
std::optional<int> group_bandwidth(const std::string& membership,
                                   const std::filesystem::path& mount);

/// The number of threads that the user requests: the option if given, else the environment variable
/// POLHODE_THREADS, else allowed_threads().
/// @throws Error  if the number is not an integer from 1 to allowed_threads()
int requested_threads(std::optional<int> option);

/// The number of threads that the user requests, from the text of the option. The text is empty if
/// the option was not given.
/// @param place  name of the option for error messages, such as "--threads"
int requested_threads(const std::string& option, const std::string& place = "threads");

}  // namespace polhode
