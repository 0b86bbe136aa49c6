// SPDX-License-Identifier: MIT
// Standard output and standard error, which may be closed, full or broken pipes.
#pragma once

#include <fmt/core.h>

#include <cstdio>
#include <string>
#include <utility>

namespace polhode::cli {

/// Opens replacements for closed standard streams, so that no other file gets their descriptors.
/// Signals from closed pipes and file size limits become write errors. Call this function first.
void prepare_streams();

/// The exit code of the program, where `code` is the exit code if all output succeeds. If standard
/// output could not be written completely, the exit code is 1 instead of 0, and a message is
/// printed.
int exit_code(int code);

/// Prints to standard error. Write errors are ignored, so that an unwritable log does not end a
/// run.
template <class... Args>
void log(fmt::format_string<Args...> format, Args&&... args) {
  const std::string text = fmt::format(format, std::forward<Args>(args)...);
  std::fwrite(text.data(), 1, text.size(), stderr);
}

}  // namespace polhode::cli
