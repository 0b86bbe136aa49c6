// SPDX-License-Identifier: MIT
// What may crash, for reasons that are not ours, in a process of its own.
#pragma once

#include <functional>

namespace polhode {

/// Carries an action out in a copy of this process, which prints nothing and ends with it.
/// @param cpu_seconds  of the processor that it may take; 0: without a limit
/// @return  whether it came to its end, without an exception or a signal
bool done_in_own_process(const std::function<void()>& action, unsigned cpu_seconds = 0);

}  // namespace polhode
