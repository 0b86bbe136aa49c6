// SPDX-License-Identifier: MIT
// A replacement of std::from_chars for all numbers, because libc++ supports floating-point numbers
// only from version 20 on.
#pragma once

#include <locale.h>
#include <stdlib.h>

#include <charconv>
#include <cmath>
#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#ifdef __APPLE__
#include <xlocale.h>
#endif

namespace polhode {

/// A replacement for std::from_chars, based on strtod in the locale "C". Unlike std::from_chars,
/// this function also reads blanks, a plus sign and hexadecimal numbers. Numbers too small for the
/// type become 0.
template <std::floating_point T>
std::from_chars_result from_chars_by_strtod(const char* first, const char* last, T& value) {
  static const locale_t plain = newlocale(LC_ALL_MASK, "C", nullptr);
  const std::string_view all(first, static_cast<std::size_t>(last - first));
  if (all.find_first_of("0123456789.-infINF") != 0) return {first, std::errc::invalid_argument};
  const std::string text(all.substr(0, all.find_first_of("xX")));
  char* end = nullptr;
  const auto number = static_cast<T>(strtod_l(text.c_str(), &end, plain));
  const std::size_t length = static_cast<std::size_t>(end - text.c_str());
  if (length == 0) return {first, std::errc::invalid_argument};
  const bool finite = std::isfinite(number);
  if (!finite && all.substr(0, length).find_first_of("infINF") == std::string_view::npos)
    return {first + length, std::errc::result_out_of_range};
  value = number;
  return {first + length, std::errc()};
}

template <class T>
std::from_chars_result from_chars(const char* first, const char* last, T& value) {
#ifndef __cpp_lib_to_chars
  if constexpr (std::floating_point<T>)
    return from_chars_by_strtod(first, last, value);
  else
#endif
    return std::from_chars(first, last, value);
}

/// The number in a text that contains only this number; empty for any other text.
template <class T>
std::optional<T> parsed_number(std::string_view text) {
  T value{};
  const char* const end = text.data() + text.size();
  const auto [last, status] = from_chars(text.data(), end, value);
  if (status != std::errc() || last != end) return std::nullopt;
  return value;
}

}  // namespace polhode
