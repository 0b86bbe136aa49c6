// SPDX-License-Identifier: MIT
// Text on its way to a stream: collected, and written in large pieces.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <ostream>
#include <string_view>

namespace polhode {

class TextBuffer {
 public:
  explicit TextBuffer(std::ostream& out) : out_(out) {}
  ~TextBuffer() { flush(); }
  TextBuffer(const TextBuffer&) = delete;
  TextBuffer& operator=(const TextBuffer&) = delete;

  template <class... Arguments>
  void print(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Arguments>(arguments)...);
  }
  void append(std::string_view text) { text_.append(text); }
  /// As "{:width.decimalsf}", in half of the time.
  void fixed(double x, std::size_t width, int decimals) {
    std::array<char, 512> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), x,
                                   std::chars_format::fixed, decimals)
                         .ptr;
    const auto length = static_cast<std::size_t>(end - digits.data());
    for (std::size_t k = length; k < width; ++k) text_.push_back(' ');
    text_.append(digits.data(), end);
  }
  void end_line() {
    text_.push_back('\n');
    if (text_.size() > piece) flush();
  }
  void flush() {
    out_.write(text_.data(), static_cast<std::streamsize>(text_.size()));
    text_.clear();
  }

 private:
  static constexpr std::size_t piece = 1 << 20;  // bytes
  std::ostream& out_;
  fmt::memory_buffer text_;
};

}  // namespace polhode
