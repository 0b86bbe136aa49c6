// SPDX-License-Identifier: MIT
// What does not fit into memory is refused before it is asked for: afterwards there may be nobody
// left to say so.
#pragma once

#include <string>

namespace polhode {

/// Memory that the process may have in all [bytes]: that of the computer, or less where a limit of
/// the process (ulimit -v) or of its control group says so.
double memory_limit();

/// Refuses what cannot fit.
/// @param bytes   at least so many
/// @param what    that takes them, in the plural: "100000000 molecules"
/// @param remedy  what to do instead: "take fewer"
/// @throws Error  if that is more than memory_limit()
void require_memory(double bytes, const std::string& what, const std::string& remedy);

}  // namespace polhode
