// SPDX-License-Identifier: MIT
// Reads a text line by line.
#pragma once

#include <fmt/core.h>

#include <cmath>
#include <cstddef>
#include <istream>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "base/from_chars.hpp"
#include "io/files/split_words.hpp"
#include "io/files/text_file.hpp"
#include "polhode/base/error.hpp"

namespace polhode {

/// The number in a field, which may have blanks around it.
template <class Number>
std::optional<Number> parsed(std::string_view field) {
  field = trimmed(field);
  if (field.starts_with('+')) field.remove_prefix(1);
  return parsed_number<Number>(field);
}

/// Reads a text line by line and keeps the line number for errors.
class Lines {
 public:
  Lines(std::istream& in, std::string file) : in_(in), file_(std::move(file)) {}

  const std::string& file() const { return file_; }

  /// The next line, without the line end; valid until the next call. The result is empty at the end
  /// of the text.
  std::optional<std::string_view> next() {
    ++number_;
    if (!std::getline(in_, line_)) return std::nullopt;
    if (line_.ends_with('\r')) line_.pop_back();
    if (const auto odd = odd_byte(line_, file_)) refuse(*odd);
    return number_ == 1 ? without_mark(line_) : line_;
  }
  /// Throws an Error about a line.
  /// @param expected  description of the expected line
  template <class Expected>
  std::string_view next(const Expected& expected) {
    const auto line = next();
    if (!line) refuse(fmt::format("the file ends before {}", expected()));
    return *line;
  }
  [[noreturn]] void refuse(const std::string& what) const {
    throw Error(what, fmt::format("{}:{}", file_, number_));
  }
  /// A finite number in a field.
  /// @param hint  explanation of the field's position, such as "; atom lines have columns of fixed
  ///   width"
  double number(std::string_view field, const char* what, const char* hint = "") const {
    const auto value = parsed<double>(field);
    if (!value)
      refuse(fmt::format("found '{}' for the {}, which must be a number{}", trimmed(field), what,
                         hint));
    if (!std::isfinite(*value))
      refuse(fmt::format("the {} is {}; it must be a finite number", what, trimmed(field)));
    return *value;
  }

 private:
  std::istream& in_;
  std::string file_, line_;
  std::size_t number_ = 0;
};

}  // namespace polhode
