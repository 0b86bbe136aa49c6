// SPDX-License-Identifier: MIT
#include "own_process.hpp"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>

namespace polhode {
namespace {

[[noreturn]] void carry_out(const std::function<void()>& action, unsigned cpu_seconds) {
  const rlimit seconds{cpu_seconds, cpu_seconds}, none{0, 0};
  if (cpu_seconds > 0) ::setrlimit(RLIMIT_CPU, &seconds);
  ::setrlimit(RLIMIT_CORE, &none);
  ::close(STDERR_FILENO);
  try {
    action();
  } catch (...) {
    ::_exit(1);
  }
  ::_exit(0);
}

}  // namespace

bool done_in_own_process(const std::function<void()>& action, unsigned cpu_seconds) {
  const pid_t process = ::fork();
  if (process == 0) carry_out(action, cpu_seconds);
  if (process < 0) return false;
  int status = -1;
  while (::waitpid(process, &status, 0) < 0)
    if (errno != EINTR) return false;
  return status == 0;
}

}  // namespace polhode
