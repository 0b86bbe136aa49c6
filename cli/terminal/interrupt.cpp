// SPDX-License-Identifier: MIT
#include "interrupt.hpp"

#include <atomic>
#include <csignal>
#include <initializer_list>

namespace polhode::cli {
namespace {

// All threads of a study read this flag, and the signal handler may run in any of these threads.
std::atomic<bool> caught = false;
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void remember(int) { caught = true; }

void take(int signal_number, int flags) {
  struct sigaction action {};
  action.sa_handler = remember;
  action.sa_flags = flags;
  sigaction(signal_number, &action, nullptr);
}

}  // namespace

void catch_interrupts() {
  // A second signal has its default effect and ends the program at once.
  for (const int signal_number : {SIGINT, SIGTERM})
    take(signal_number, static_cast<int>(SA_RESETHAND));
  // The system may send SIGXCPU every second beyond the CPU time limit, and SIGHUP more than once
  // when a terminal closes.
  take(SIGXCPU, 0);
  struct sigaction hangup {};
  sigaction(SIGHUP, nullptr, &hangup);
  if (hangup.sa_handler != SIG_IGN) take(SIGHUP, 0);  // nohup ignores this signal
}

bool interrupted() { return caught; }

}  // namespace polhode::cli
