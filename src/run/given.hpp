// SPDX-License-Identifier: MIT
// Options of a job as a front end was given them: texts with the names that they have there.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/suggest.hpp"
#include "io/settings/quantity.hpp"
#include "polhode/base/enum_names.hpp"
#include "polhode/base/error.hpp"

namespace polhode {

/// The text of an option; empty: the option is not given.
struct Given {
  std::string text;
  std::string name;  ///< in the front end, "--cutoff", for errors

  explicit operator bool() const { return !text.empty(); }
};

/// A row of the options of a request: front ends declare and fill options in loops over them.
template <class Request>
struct RequestOption {
  const char* name;  ///< "max_force": --max-force, or the keyword max_force
  Given Request::*member;
  std::string doc;
  const char* old_name = nullptr;  ///< which is accepted, too
};

/// Throws `cutoff = "-1 nm" complaint`, with the option as its place.
[[noreturn]] void refuse(const Given& given, const std::string& complaint);

/// @throws Error  unless it is a quantity of the dimension
double given_quantity(const Given& given, Dimension dimension, std::string_view example = {});
/// A quantity above 0.
double given_positive(const Given& given, Dimension dimension, std::string_view example = {});
/// Sets a value above 0 if the option is given.
void take_positive(double& value, const Given& given, Dimension dimension,
                   std::string_view example = {});
/// A fraction above 0 and below 1, "0.5 %".
double given_fraction(const Given& given);
/// A number from min to max.
double given_number(const Given& given, double min, double max);
/// As many numbers, with commas between them.
std::vector<double> given_numbers(const Given& given, std::size_t count, std::string_view example);
std::uint64_t given_whole_number(const Given& given, std::uint64_t min, std::uint64_t max);
/// Splits "a, b" into words.
std::vector<std::string> given_words(const Given& given);

/// The value of a named enumeration.
template <NamedEnum Enum>
Enum given_name(const Given& given) {
  if (const auto value = value_of<Enum>(given.text)) return *value;
  refuse(given, must_be_one_of(enum_names<Enum>, given.text));
}

}  // namespace polhode
