// SPDX-License-Identifier: MIT
// The control groups of a process, which limit its cores and its memory.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace polhode {

/// The groups of this process as in /proc/self/cgroup; empty without control groups.
std::string control_group_membership();

/// The folders of a process's groups and of all groups that contain them, for versions 1 and 2 of
/// control groups. Some folders may not exist, because in a container the group of the process may
/// be mounted as the root.
/// @param controller  controller such as "cpu" or "memory"
/// @param membership  contents of /proc/self/cgroup
/// @param mount       folder where the control groups are mounted, usually /sys/fs/cgroup
/// @source  cgroups(7)
std::vector<std::filesystem::path> control_groups(const std::string& controller,
                                                  const std::string& membership,
                                                  const std::filesystem::path& mount);

}  // namespace polhode
