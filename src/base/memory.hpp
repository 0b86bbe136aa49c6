// SPDX-License-Identifier: MIT
// Memory requirements are checked before allocation: a process that exceeds its limit may be killed
// without a message.
#pragma once

#include <filesystem>
#include <string>

namespace polhode {

/// Total memory that the process may use [bytes]: the memory of the computer, or a lower limit of
/// the process (ulimit -v) or of its control group.
double memory_limit();

/// The lowest memory limit of control groups [bytes]; infinite if there is none.
/// @param membership  contents of /proc/self/cgroup
/// @param mount       folder where the control groups are mounted
double group_memory_limit(const std::string& membership, const std::filesystem::path& mount);

/// Throws an Error if a request exceeds the memory limit.
/// @param bytes   lower estimate of the required memory
/// @param what    objects that need the memory, in the plural: "100000000 molecules"
/// @param remedy  advice to the user: "use fewer"
/// @throws Error  if the request is larger than memory_limit()
void require_memory(double bytes, const std::string& what, const std::string& remedy);

}  // namespace polhode
