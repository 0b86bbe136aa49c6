// SPDX-License-Identifier: MIT
#include "io/figures/gnuplot_text.hpp"

#include <filesystem>

#include "base/printable.hpp"

namespace polhode {

std::string gnuplot_text(std::string_view text) {
  std::string result = "'";
  for (const char c : printable(text)) result += c == '\'' ? std::string("''") : std::string(1, c);
  return result + "'";
}

std::string gnuplot_file(std::string_view path) {
  return gnuplot_text("./" + std::filesystem::path(path).filename().string());
}

// A backslash at the end of a line would join the line with the next line.
std::string gnuplot_comment(std::string_view text) {
  std::string line = printable(text);
  while (line.ends_with('\\')) line.pop_back();
  return line;
}

}  // namespace polhode
