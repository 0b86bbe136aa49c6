// SPDX-License-Identifier: MIT
// Memory requirements are checked before allocation: a process that exceeds its limit may be killed
// without a message.
#pragma once

#include <string>

namespace polhode {

/// Total memory that the process may use [bytes]: the memory of the computer, or a lower limit of
/// the process (ulimit -v) or of its control group.
double memory_limit();

/// The lowest memory limit of the control groups of a process [bytes]; infinite if there is none.
/// Versions 1 and 2 of control groups are supported.
/// @param groups  file with the groups of the process: "/proc/self/cgroup"
/// @param root    folder of all groups: "/sys/fs/cgroup"
double group_memory_limit(const std::string& groups, const std::string& root);

/// Throws an Error if a request exceeds the memory limit.
/// @param bytes   lower estimate of the required memory
/// @param what    objects that need the memory, in the plural: "100000000 molecules"
/// @param remedy  advice to the user: "use fewer"
/// @throws Error  if the request is larger than memory_limit()
void require_memory(double bytes, const std::string& what, const std::string& remedy);

}  // namespace polhode
