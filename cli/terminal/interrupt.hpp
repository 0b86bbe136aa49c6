// SPDX-License-Identifier: MIT
// Ctrl-C, SIGTERM, SIGHUP and SIGXCPU set a flag that loops poll, so that results so far are
// written.
#pragma once

namespace polhode::cli {

/// From now on the signals only set a flag; a second Ctrl-C or SIGTERM ends the program at once.
void catch_interrupts();

bool interrupted();

}  // namespace polhode::cli
