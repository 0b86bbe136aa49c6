// SPDX-License-Identifier: MIT
// Memory requirements are checked before allocation: a process that exceeds its limit may be killed
// without a message.
#pragma once

#include <string>

namespace polhode {

/// Total memory that the process may use [bytes]: that of the computer, or a lower limit of the
/// process (ulimit -v) or of its control group.
double memory_limit();

/// Throws if a request cannot fit into memory.
/// @param bytes   lower estimate of the request
/// @param what needs them, in the plural: "100000000 molecules"
/// @param remedy  what to do instead: "use fewer"
/// @throws Error  if that is more than memory_limit()
void require_memory(double bytes, const std::string& what, const std::string& remedy);

}  // namespace polhode
