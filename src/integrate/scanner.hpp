// SPDX-License-Identifier: MIT
// A scanner, which reads words and numbers of a scheme text and reports errors with their position.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace polhode {

/// An example of a scheme text for error messages.
inline constexpr const char* example_scheme = "B(1/6) A(1/2) B(2/3, 1/48) A(1/2) B(1/6)";

class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  std::size_t at() const { return at_; }
  void go_to(std::size_t at) { at_ = at; }
  /// Whether only white space is left in the text.
  bool at_end();
  /// Whether the next character that is not white space is `c`.
  bool next_is(char c);
  /// Whether the next character that is not white space is a letter.
  bool next_is_letter();
  /// Skips the character `c` if `c` comes next, and returns whether `c` was skipped.
  bool take(char c);
  /// Skips the character `c`. @throws Error if another character comes next
  void expect(char c);
  /// Reads the next word of letters, digits and underscores; empty if the next character is not a
  /// letter.
  std::string_view word();
  /// Returns the next word, as word() does, but does not advance.
  std::string_view next_word();
  /// Reads a decimal number like 0.25 or 1e-3. @throws Error unless a finite number comes next
  double decimal();

  /// Throws an Error that gives the text found here, its position, and the text expected.
  [[noreturn]] void refuse(const std::string& expected) const;

 private:
  void skip_space();

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace polhode
