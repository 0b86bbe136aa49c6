// SPDX-License-Identifier: MIT
#include "base/printable.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "polhode/base/error.hpp"

namespace polhode {
namespace {

/// Length of the UTF-8 sequence at the front of a text. The length is 0 for a control character or
/// an invalid sequence (RFC 3629, section 4).
std::size_t printable_length(std::string_view text) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const unsigned char first = byte(0);
  if (first < 0x80) return first < ' ' || first == 0x7f ? 0 : 1;
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4 || length > text.size()) return 0;
  for (std::size_t k = 1; k < length; ++k)
    if ((byte(k) & 0xc0) != 0x80) return 0;
  const unsigned char second = byte(1);
  const bool control = first == 0xc2 && second < 0xa0;
  const bool too_long = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
  const bool surrogate = first == 0xed && second >= 0xa0;
  const bool beyond = first == 0xf4 && second >= 0x90;
  return control || too_long || surrogate || beyond ? 0 : length;
}

}  // namespace

std::string printable(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t length = printable_length(text);
    if (length > 0)
      result += text.substr(0, length);
    else
      result += fmt::format("\\x{:02x}", static_cast<unsigned char>(text[0]));
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return result;
}

std::size_t character_count(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xc0) != 0x80;
  }));
}

void check_name(std::string_view what, std::string_view name) {
  for (std::string_view rest = name; !rest.empty();) {
    const std::size_t length = printable_length(rest);
    if (length == 0)
      throw Error(
          fmt::format("the name of {}, '{}', contains the byte 0x{:02x}, which is a control "
                      "character or not UTF-8; choose another name of printable characters",
                      what, printable(name), static_cast<unsigned char>(rest[0])));
    rest.remove_prefix(length);
  }
}

}  // namespace polhode
