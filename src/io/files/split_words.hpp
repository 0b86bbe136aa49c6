// SPDX-License-Identifier: MIT
// Words of a line, separated by blanks.
#pragma once

#include <string_view>
#include <vector>

namespace polhode {

inline constexpr std::string_view blanks = " \t\r\f\v";

/// Removes blanks at both ends.
inline std::string_view trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(blanks);
  if (begin == text.npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

/// Removes the byte order mark that some editors put before a text.
inline std::string_view without_mark(std::string_view text) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  if (text.starts_with(mark)) text.remove_prefix(mark.size());
  return text;
}

/// Removes the first word, with the blanks around it, from the front of a text and returns it;
/// empty at the end of the text.
inline std::string_view take_word(std::string_view& text) {
  text = trimmed(text);
  const std::string_view word = text.substr(0, text.find_first_of(blanks));
  text.remove_prefix(word.size());
  return word;
}

/// The parts of a text between separators, without blanks at their ends; parts may be empty.
inline std::vector<std::string_view> parts_of(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const auto end = text.find(separator);
    parts.push_back(trimmed(text.substr(0, end)));
    if (end == text.npos) return parts;
    text.remove_prefix(end + 1);
  }
}

}  // namespace polhode
