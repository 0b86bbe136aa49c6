// SPDX-License-Identifier: MIT
// Ctrl-C, SIGTERM, SIGHUP and SIGXCPU set a flag that loops poll, so that a job can write its
// results before it ends.
#pragma once

namespace polhode::cli {

/// Installs handlers, so that the signals only set a flag. A second Ctrl-C or SIGTERM ends the
/// program immediately.
void catch_interrupts();

bool interrupted();

}  // namespace polhode::cli
