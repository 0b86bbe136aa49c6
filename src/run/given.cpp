// SPDX-License-Identifier: MIT
#include "run/given.hpp"

#include <fmt/core.h>

#include <sstream>
#include <system_error>

#include "base/from_chars.hpp"
#include "io/settings/required_bias.hpp"

namespace polhode {
namespace {

template <class Number>
bool read(const std::string& text, Number& value) {
  const char* const end = text.data() + text.size();
  const auto [last, status] = from_chars(text.data(), end, value);
  return status == std::errc() && last == end;
}

}  // namespace

void refuse(const Given& given, const std::string& complaint) {
  throw Error(fmt::format("{} = \"{}\" {}", given.name, given.text, complaint));
}

double given_quantity(const Given& given, Dimension dimension, std::string_view example) {
  return quantity(given.text, dimension, given.name, example);
}

double given_positive(const Given& given, Dimension dimension, std::string_view example) {
  const double value = given_quantity(given, dimension, example);
  if (!(value > 0))
    refuse(given, dimension == Dimension::time
                      ? "must be longer than 0; write for example \"2 fs\""
                      : fmt::format("must be above 0 {}", unit_of(dimension)));
  return value;
}

void take_positive(double& value, const Given& given, Dimension dimension,
                   std::string_view example) {
  if (given) value = given_positive(given, dimension, example);
}

double given_fraction(const Given& given) {
  const double value = given_quantity(given, Dimension::fraction);
  if (const std::string wrong = wrong_bound(value); !wrong.empty()) refuse(given, wrong);
  return value;
}

double given_number(const Given& given, double min, double max) {
  double value = 0;
  if (!read(given.text, value) || !(value >= min && value <= max))
    refuse(given, fmt::format("must be a number from {:.15g} to {:.15g}", min, max));
  return value;
}

std::vector<double> given_numbers(const Given& given, std::size_t count, std::string_view example) {
  std::vector<double> numbers;
  bool all = true;
  for (const std::string& word : given_words(given))
    all = read(word, numbers.emplace_back()) && all;
  if (!all || numbers.size() != count)
    refuse(given, fmt::format("must be {}; write for example {}",
                              count == 1 ? "a number" : fmt::format("{} numbers", count), example));
  return numbers;
}

std::uint64_t given_whole_number(const Given& given, std::uint64_t min, std::uint64_t max) {
  std::uint64_t value = 0;
  if (!read(given.text, value) || value < min || value > max)
    refuse(given, fmt::format("must be a whole number from {} to {}", min, max));
  return value;
}

std::vector<std::string> given_words(const Given& given) {
  std::vector<std::string> found;
  std::istringstream parts(given.text);
  for (std::string part; std::getline(parts, part, ',');) {
    const auto first = part.find_first_not_of(' '), last = part.find_last_not_of(' ');
    if (first != part.npos) found.push_back(part.substr(first, last - first + 1));
  }
  return found;
}

}  // namespace polhode
