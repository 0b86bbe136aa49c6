// SPDX-License-Identifier: MIT
// A line of a text file as fields separated by blanks, with the position of the line for error
// messages.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "polhode/io/settings/text_place.hpp"

namespace polhode {

inline constexpr std::size_t max_name_length = 63;

class FieldLine {
 public:
  /// Splits a line into fields.
  /// @param text  line; must outlive this object
  FieldLine(std::string_view text, TextPlace place);

  std::size_t size() const { return fields_.size(); }
  std::string_view operator[](std::size_t k) const { return fields_[k]; }
  /// The name in field k.
  /// @throws Error  if the name is longer than `max_name_length`; the limit exists because macros
  ///   can expand a short file enormously
  std::string word(std::size_t k) const;
  const TextPlace& place() const { return place_; }

  /// The number in field k; `what` names the quantity, such as "charge".
  /// @throws Error  if the field is not a finite number
  double number(std::size_t k, std::string_view what) const;
  /// The integer in field k.
  /// @throws Error  if the field is not an integer from `minimum` to `maximum`
  std::int64_t integer(std::size_t k, std::string_view what, std::int64_t minimum,
                       std::int64_t maximum) const;
  /// Checks the number of fields.
  /// @param what  names of the required fields
  /// @throws Error  if there are fewer fields than `minimum`
  void require(std::size_t minimum, std::string_view what) const;

  [[noreturn]] void refuse(const std::string& what) const;

 private:
  std::vector<std::string_view> fields_;
  TextPlace place_;
};

}  // namespace polhode
