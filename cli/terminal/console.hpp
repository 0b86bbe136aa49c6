// SPDX-License-Identifier: MIT
// The callbacks of a job that runs from the command line.
#pragma once

#include "polhode/run/callbacks.hpp"

namespace polhode::cli {

/// Shows messages and progress, with the expected end, on standard error: see ProgressLine. Ctrl-C,
/// SIGTERM, SIGHUP and SIGXCPU end the job early (interrupt.hpp). The line disappears with the last
/// copy of the callbacks.
Callbacks console();

}  // namespace polhode::cli
