// SPDX-License-Identifier: MIT
// How many threads a process may have, and how many its user wants.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace polhode {

/// How many cores this process may use, 1 or more: those it is bound to, and no more than the
/// bandwidth (rounded up) that its control groups leave it.
/// @source  sched_setaffinity(2); cgroups(7); cpu.max of version 2, cpu.cfs_quota_us of version 1
int allowed_threads();

/// The bandwidth of control groups in cores, rounded up; nothing if they set no bound.
/// @param membership  what /proc/self/cgroup holds
/// @param mount       where the control groups are seen as files
std::optional<int> group_bandwidth(const std::string& membership,
                                   const std::filesystem::path& mount);

/// The option if there is one, else the environment variable POLHODE_THREADS, else all that are
/// allowed.
/// @throws Error  if that is no whole number from 1 to allowed_threads()
int threads_wanted(std::optional<int> option);

/// The same of an option as it was typed; empty without one.
int threads_wanted(const std::string& option);

}  // namespace polhode
