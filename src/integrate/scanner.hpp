// SPDX-License-Identifier: MIT
// A position in the text of a scheme: what comes next, and errors that say where.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace polhode {

/// An example for error messages.
inline constexpr const char* example_scheme = "B(1/6) A(1/2) B(2/3, 1/48) A(1/2) B(1/6)";

class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  std::size_t at() const { return at_; }
  void go_to(std::size_t at) { at_ = at; }
  /// Whether only white space is left.
  bool at_end();
  /// Whether the next character that is not white space is this one.
  bool next_is(char c);
  /// Whether the next character that is not white space is a letter.
  bool next_is_letter();
  /// Skips that character if it is the next one, and returns whether it was.
  bool take(char c);
  /// Skips that character. @throws Error if it is not the next one
  void expect(char c);
  /// Reads the next letters, digits and underscores; empty if a letter does not come next.
  std::string_view word();
  /// The same, but stays at the current position.
  std::string_view next_word();
  /// Reads a decimal number like 0.25 or 1e-3. @throws Error unless there is a finite one
  double decimal();

  /// Throws an Error: what is found here, where, and what is expected.
  [[noreturn]] void refuse(const std::string& expected) const;

 private:
  void skip_space();

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace polhode
