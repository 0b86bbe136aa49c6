// SPDX-License-Identifier: MIT
// Options of a job as texts that a front end received, with the option names of this front end.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/suggest.hpp"
#include "io/settings/quantity.hpp"
#include "polhode/base/enum_names.hpp"
#include "polhode/base/error.hpp"

namespace polhode {

/// The text of an option; empty if the option is not given.
struct Given {
  std::string text;
  std::string name;  ///< option name in the front end, such as "--cutoff", for error messages

  explicit operator bool() const { return !text.empty(); }
};

/// An entry in the list of options of a request. Front ends loop over the list to declare and fill
/// all options.
template <class Request>
struct RequestOption {
  const char* name;  ///< name such as "max_force", for the option --max-force and the keyword
                     ///< max_force
  Given Request::*member;
  std::string doc;
  const char* old_name = nullptr;  ///< older name, which is also accepted
};

/// Throws an Error of the form `cutoff = "-1 nm" complaint`, with the option as the place of the
/// error.
[[noreturn]] void refuse(const Given& given, const std::string& complaint);

/// The value of a quantity given as an option.
/// @throws Error  unless the text is a quantity of this dimension
double given_quantity(const Given& given, Dimension dimension, std::string_view example = {});
/// The value of a quantity given as an option, which must be above 0.
double given_positive(const Given& given, Dimension dimension, std::string_view example = {});
/// Sets a value if the option is given; the value must be above 0.
void take_positive(double& value, const Given& given, Dimension dimension,
                   std::string_view example = {});
/// The value of a fraction given as an option, such as "0.5 %", which must be above 0 and below 1.
double given_fraction(const Given& given);
/// The value of a number given as an option, which must be from min to max.
double given_number(const Given& given, double min, double max);
/// The values of several numbers given as an option, separated by commas.
std::vector<double> given_numbers(const Given& given, std::size_t count, std::string_view example);
std::uint64_t given_whole_number(const Given& given, std::uint64_t min, std::uint64_t max);
/// Splits "a, b" into words.
std::vector<std::string> given_words(const Given& given);

/// The value of a named enumeration given as an option.
template <NamedEnum Enum>
Enum given_name(const Given& given) {
  if (const auto value = value_of<Enum>(given.text)) return *value;
  refuse(given, must_be_one_of(enum_names<Enum>, given.text));
}

}  // namespace polhode
