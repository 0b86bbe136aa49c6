// SPDX-License-Identifier: MIT
// Ctrl-C and SIGTERM as a flag that loops poll, so that the results so far are still written.
#pragma once

namespace polhode::cli {

/// From now on, the first signal only sets a flag; a second one terminates the program.
void catch_interrupts();

bool interrupted();

}  // namespace polhode::cli
