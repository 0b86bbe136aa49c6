// SPDX-License-Identifier: MIT
#include "interrupt.hpp"

#include <atomic>
#include <csignal>

namespace polhode::cli {
namespace {

// The flag is read by all threads of a study, while the handler may run in any of them.
std::atomic<bool> caught = false;
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void remember(int) { caught = true; }

}  // namespace

void catch_interrupts() {
  struct sigaction action {};
  action.sa_handler = remember;
  action.sa_flags = static_cast<int>(SA_RESETHAND);  // a second signal has its default effect
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool interrupted() { return caught; }

}  // namespace polhode::cli
