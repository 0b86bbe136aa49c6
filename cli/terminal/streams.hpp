// SPDX-License-Identifier: MIT
// Standard output and standard error, which may be closed, full or broken pipes.
#pragma once

#include <fmt/core.h>

#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace polhode::cli {

/// Opens replacements for closed standard streams, so that no file gets their descriptors, and
/// turns the signals of closed pipes and file size limits into write errors. Call it first.
void prepare_streams();

/// The exit code of a program that ends with `code`: 1 instead of 0, with a message, if standard
/// output could not be written completely.
int exit_code(int code);

/// Prints to standard error. Write errors are ignored: no run ends because of its log.
template <class... Args>
void log(fmt::format_string<Args...> format, Args&&... args) {
  const std::string text = fmt::format(format, std::forward<Args>(args)...);
  std::fwrite(text.data(), 1, text.size(), stderr);
}

}  // namespace polhode::cli
