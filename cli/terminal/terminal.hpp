// SPDX-License-Identifier: MIT
// The width of a terminal, and texts that fit into it.
#pragma once

#include <string>
#include <string_view>

namespace polhode::cli {

/// Wraps a text at the environment variable COLUMNS, or at the width of the terminal to which a
/// stream is connected. The text is unchanged if the stream is a pipe or a file.
std::string fit_to_terminal(std::string_view text, int stream);

/// Prints a text to standard output. The text is wrapped if standard output is a terminal.
void print_fitted(std::string_view text);

}  // namespace polhode::cli
