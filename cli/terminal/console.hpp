// SPDX-License-Identifier: MIT
// The callbacks of a job that runs from the command line.
#pragma once

#include "polhode/run/callbacks.hpp"

namespace polhode::cli {

/// Makes callbacks that show messages and progress with the expected end time on standard error.
/// Ctrl-C, SIGTERM, SIGHUP and SIGXCPU end the job early, so that the job can write its results.
/// The progress line disappears when the last copy of the callbacks is destroyed.
Callbacks console();

}  // namespace polhode::cli
