// SPDX-License-Identifier: MIT
#include "variable_text.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstring>

namespace polhode::hdf5 {
namespace {

// What the process does: it may crash, and takes a second of the processor's time at most.
[[noreturn]] void read_into(int pipe, hid_t attribute, hid_t type) {
  const rlimit one{1, 1}, none{0, 0};
  ::setrlimit(RLIMIT_CPU, &one);
  ::setrlimit(RLIMIT_CORE, &none);
  ::close(STDERR_FILENO);
  std::array<char*, most_texts> texts{};
  if (H5Aread(attribute, type, texts.data()) < 0 || texts[0] == nullptr) ::_exit(1);
  const std::size_t length = ::strnlen(texts[0], longest_text);
  ::_exit(::write(pipe, texts[0], length) == static_cast<ssize_t>(length) ? 0 : 1);
}

}  // namespace

std::optional<std::string> variable_text(hid_t attribute, hid_t type) {
  std::array<int, 2> pipe{};
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0) return std::nullopt;
  const pid_t reader = ::fork();
  if (reader == 0) read_into(pipe[1], attribute, type);
  ::close(pipe[1]);
  std::string text(longest_text, '\0');
  const ssize_t length = TEMP_FAILURE_RETRY(::read(pipe[0], text.data(), text.size()));
  ::close(pipe[0]);
  int status = -1;
  if (reader > 0) TEMP_FAILURE_RETRY(::waitpid(reader, &status, 0));
  if (length < 0 || status != 0) return std::nullopt;
  text.resize(static_cast<std::size_t>(length));
  return text;
}

}  // namespace polhode::hdf5
