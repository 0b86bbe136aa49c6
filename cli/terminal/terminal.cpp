// SPDX-License-Identifier: MIT
#include "terminal.hpp"

#include <fmt/core.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>

namespace polhode::cli {
namespace {

constexpr std::size_t min_width = 40, max_indent = 30;  // smallest width, and largest indent of the
                                                        // parser's column of meanings

/// The display width of a text in columns, which is the number of bytes that begin a UTF-8
/// character.
std::size_t columns(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](unsigned char c) { return (c & 0xc0) != 0x80; }));
}

/// The column at which a wrapped line continues. Usually, this is the column at which the line
/// begins. If the line has a label and two blanks, the text after the blanks gives the column.
std::size_t indent_of(std::string_view line, std::size_t width) {
  const auto begin = line.find_first_not_of(' ');
  const auto text = line.find_first_not_of(' ', line.find("  ", begin));
  return std::min({text == line.npos ? begin : text, max_indent, width / 2});
}

/// The number of bytes from the beginning of a line to the last blank at which the line can be
/// broken so that it fits. If the line has no blank, the result is the length of the whole line.
std::size_t fitting(std::string_view line, std::size_t width) {
  std::size_t end = line.npos;
  const std::size_t first = line.find_first_not_of(' ');
  for (auto blank = line.find(' ', first); blank != line.npos; blank = line.find(' ', blank + 1)) {
    if (columns(line.substr(0, blank)) > width && end != line.npos) break;
    end = blank;
    if (columns(line.substr(0, blank)) > width) break;
  }
  return std::min(end, line.size());
}

/// Wraps a text between words, so that lines have at most `width` columns. Continuation lines are
/// indented to the column of the text after the line's label, such as an option's description.
std::string wrapped(std::string_view text, std::size_t width) {
  std::string result;
  while (!text.empty()) {
    const auto end = std::min(text.find('\n'), text.size());
    std::string line(text.substr(0, end));
    const std::string indent(indent_of(line, width), ' ');
    while (columns(line) > width) {
      const std::size_t fits = fitting(line, width);
      if (fits == line.size()) break;
      const auto next = line.find_first_not_of(' ', fits);
      if (next == line.npos) break;
      result.append(line, 0, line.find_last_not_of(' ', fits) + 1).append("\n");
      line = indent + line.substr(next);
    }
    result += line;
    if (end < text.size()) result += '\n';
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return result;
}

}  // namespace

std::string fit_to_terminal(std::string_view text, int stream) {
  std::size_t width = 0;
  if (const char* const set = std::getenv("COLUMNS")) {
    const std::string_view digits = set;
    std::from_chars(digits.data(), digits.data() + digits.size(), width);
  }
  winsize size{};
  if (width == 0 && ::isatty(stream) != 0 && ::ioctl(stream, TIOCGWINSZ, &size) == 0)
    width = size.ws_col;
  return width == 0 ? std::string(text) : wrapped(text, std::max(width, min_width));
}

void print_fitted(std::string_view text) { fmt::print("{}", fit_to_terminal(text, STDOUT_FILENO)); }

}  // namespace polhode::cli
