// SPDX-License-Identifier: MIT
// The callbacks of a job that runs in a terminal.
#pragma once

#include "polhode/run/callbacks.hpp"

namespace polhode::cli {

/// Messages on standard error; a progress line there, with the expected end, if it is a terminal;
/// Ctrl-C, SIGTERM, SIGHUP and SIGXCPU end the job early (interrupt.hpp). The line disappears with
/// the last copy of the callbacks.
Callbacks console();

}  // namespace polhode::cli
