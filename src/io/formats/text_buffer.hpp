// SPDX-License-Identifier: MIT
// A text buffer, written to a stream in large pieces.
#pragma once

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
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
  /// Appends a number in the format "{:width.decimalsf}", with the same digits as fmt but faster.
  void fixed(double x, std::size_t width, int decimals) {
    const double power = powers_of_ten.at(static_cast<std::size_t>(decimals));
    const double scaled = x * power, whole = std::nearbyint(scaled);
    if (!(std::abs(whole) < 0x1p53)) return print("{:>{}.{}f}", x, width, decimals);
    auto digits = static_cast<std::int64_t>(whole);
    // Both `lacks`, the fractional part, and `lost`, the round-off error of the product, are exact.
    const double lacks = scaled - whole, lost = std::fma(x, power, -scaled);
    if (lacks + lost > 0.5 || (lacks == 0.5 && lost > 0)) ++digits;
    if (lacks + lost < -0.5 || (lacks == -0.5 && lost < 0)) --digits;
    append_decimal(static_cast<std::uint64_t>(std::abs(digits)), std::signbit(x), width, decimals);
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
  void append_decimal(std::uint64_t digits, bool negative, std::size_t width, int decimals) {
    std::array<char, 32> text;
    char* at = text.data() + text.size();
    const auto put = [&] {
      *--at = static_cast<char>('0' + digits % 10);
      digits /= 10;
    };
    for (int k = 0; k < decimals; ++k) put();
    if (decimals > 0) *--at = '.';
    do put();
    while (digits > 0);
    if (negative) *--at = '-';
    const auto length = static_cast<std::size_t>(text.data() + text.size() - at);
    for (std::size_t k = length; k < width; ++k) text_.push_back(' ');
    text_.append(at, text.data() + text.size());
  }

  static constexpr std::array powers_of_ten = {1e0, 1e1, 1e2, 1e3, 1e4,  1e5,
                                               1e6, 1e7, 1e8, 1e9, 1e10, 1e11};
  static constexpr std::size_t piece = 1 << 16;  // size of a piece in bytes
  std::ostream& out_;
  fmt::memory_buffer text_;
};

}  // namespace polhode
