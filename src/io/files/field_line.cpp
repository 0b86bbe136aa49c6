// SPDX-License-Identifier: MIT
#include "field_line.hpp"

#include <fmt/core.h>

#include <cmath>

#include "base/from_chars.hpp"
#include "polhode/base/error.hpp"
#include "split_words.hpp"

namespace polhode {
namespace {

// A text shortened for display in a message.
std::string abbreviate(std::string_view text) {
  constexpr std::size_t max_length = 40;
  return text.size() <= max_length ? std::string(text)
                                   : std::string(text.substr(0, max_length)) + "...";
}

}  // namespace

std::string text_of(const TextPlace& place) {
  return fmt::format("{}:{}", place.file ? *place.file : "", place.line);
}

FieldLine::FieldLine(std::string_view text, TextPlace place) : place_(std::move(place)) {
  for (std::string_view word = take_word(text); !word.empty(); word = take_word(text))
    fields_.push_back(word);
}

void FieldLine::refuse(const std::string& what) const { throw Error(what, text_of(place_)); }

void FieldLine::require(std::size_t minimum, std::string_view what) const {
  if (size() < minimum)
    refuse(
        fmt::format("the line has {} fields; it must have at least {}: {}", size(), minimum, what));
}

std::string FieldLine::word(std::size_t k) const {
  const std::string_view field = fields_[k];
  if (field.size() > max_name_length)
    refuse(fmt::format("the name '{}' has {} characters; the maximum is {}", abbreviate(field),
                       field.size(), max_name_length));
  return std::string(field);
}

double FieldLine::number(std::size_t k, std::string_view what) const {
  std::string_view field = fields_[k];
  if (field.size() > 1 && field.front() == '+' && field[1] != '-') field.remove_prefix(1);
  double value = 0;
  const char* const last = field.data() + field.size();
  const auto [end, status] = from_chars(field.data(), last, value);
  if (status == std::errc::result_out_of_range || (status == std::errc() && !std::isfinite(value)))
    refuse(fmt::format("the {} is {}; it must be a finite number", what, abbreviate(field)));
  if (status != std::errc() || end != last)
    refuse(fmt::format("found '{}' for the {}, which must be a number", abbreviate(field), what));
  return value;
}

std::int64_t FieldLine::integer(std::size_t k, std::string_view what, std::int64_t minimum,
                                std::int64_t maximum) const {
  const auto value = parsed_number<std::int64_t>(fields_[k]);
  if (!value || *value < minimum || *value > maximum)
    refuse(fmt::format("found '{}' for the {}, which must be a whole number from {} to {}",
                       abbreviate(fields_[k]), what, minimum, maximum));
  return *value;
}

}  // namespace polhode
