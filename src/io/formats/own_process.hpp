// SPDX-License-Identifier: MIT
// Runs code that may crash, such as a library, in a separate process.
#pragma once

#include <functional>

namespace polhode {

/// Performs an action in a forked process, which prints nothing and then exits.
/// @param cpu_seconds  limit of CPU time; 0 for no limit
/// @return  whether the process finished without an exception or a signal
bool done_in_own_process(const std::function<void()>& action, unsigned cpu_seconds = 0);

}  // namespace polhode
