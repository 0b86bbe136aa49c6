// SPDX-License-Identifier: MIT
// The width of a terminal, and texts that fit into it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace polhode::cli {

/// A text with lines of at most `width` columns, broken between words. What is broken off continues
/// below the text of its line, as the meaning of an option does.
std::string wrapped(std::string_view text, std::size_t width);

/// A text wrapped at the environment variable COLUMNS, or at the width of the terminal that a
/// stream is; unchanged if it is none, as in a pipe or a file.
std::string fit_to_terminal(std::string_view text, int stream);

/// Prints a text to standard output, wrapped if that is a terminal.
void print_fitted(std::string_view text);

}  // namespace polhode::cli
