// SPDX-License-Identifier: MIT
#include "streams.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>

namespace polhode::cli {

void prepare_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(stream, F_GETFD) < 0 && errno == EBADF)  // open() uses the lowest free descriptor
      // The replacement of standard output is read-only, so that printing to it fails and is
      // reported.
      ::open("/dev/null", stream == STDERR_FILENO ? O_WRONLY : O_RDONLY);
  ::signal(SIGPIPE, SIG_IGN);
  ::signal(SIGXFSZ, SIG_IGN);
}

int exit_code(int code) {
  errno = 0;
  const bool lost = std::fflush(stdout) != 0 || std::ferror(stdout) != 0;
  if (!lost) return code;
  log("error: standard output could not be written completely ({}), but output files are complete; "
      "free disk space, or keep the pipe open, and repeat the command\n",
      errno != 0 ? std::strerror(errno) : "an earlier write failed");
  return code == 0 ? 1 : code;
}

}  // namespace polhode::cli
