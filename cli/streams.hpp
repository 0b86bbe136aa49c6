// SPDX-License-Identifier: MIT
// Standard output and standard error, which may be closed, full or gone.
#pragma once

#include <fmt/core.h>

#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace polhode::cli {

/// Puts something in the place of standard streams that are closed, so that no file gets their
/// numbers, and lets writing to a closed pipe or beyond the limit of a file's size be an error of
/// that write instead of the end of the program. Call it first.
void prepare_streams();

/// The exit code of a program that ends with `code`: 1 in place of 0, with a message, where
/// standard output did not take all that was printed.
int exit_code(int code);

/// Prints the names of the files that were written.
void print_files(const std::vector<std::string>& files);

/// Prints to standard error. What that does not take is lost: no run ends for a line of its log.
template <class... Args>
void log(fmt::format_string<Args...> format, Args&&... args) {
  const std::string text = fmt::format(format, std::forward<Args>(args)...);
  std::fwrite(text.data(), 1, text.size(), stderr);
}

}  // namespace polhode::cli
