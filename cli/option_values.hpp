// SPDX-License-Identifier: MIT
// Parsing of option values.
#pragma once

#include <fmt/core.h>

#include <string>
#include <utility>
#include <vector>

#include "polhode/base/error.hpp"
#include "polhode/base/suggest.hpp"
#include "polhode/forces/laws/setting_names.hpp"
#include "polhode/io/nested_scheme_text.hpp"
#include "polhode/io/quantity.hpp"

namespace polhode::cli {

/// Converts "2 fs" to ps.
/// @throws Error  if the unit is missing or the time is not positive
inline double positive_time(const std::string& text, const std::string& option) {
  const double t = quantity(text, Dimension::time, option);
  if (!(t > 0))
    throw Error(
        fmt::format("{} = \"{}\" must be longer than 0; write for example \"2 fs\"", option, text));
  return t;
}

/// The command as it could be typed, without empty options.
inline std::string typed_command(std::string command,
                                 const std::vector<std::pair<std::string, std::string>>& options) {
  for (const auto& [option, value] : options) {
    if (value.empty()) continue;
    if (!option.empty()) command += " " + option;
    const bool plain = value.find_first_of(" ()'\"") == std::string::npos;
    command += plain ? " " + value : " \"" + value + "\"";
  }
  return command;
}

/// The scheme of a name or a text, nested or not.
/// @throws Error  naming the option, if there is no such scheme
inline NestedScheme scheme_option(const std::string& text, const std::string& option) {
  try {
    return nested_scheme_of(text);
  } catch (const Error& e) {
    throw e.at(option);
  }
}

/// The value of a named enumeration.
/// @throws Error  for any word that is not a name
template <NamedEnum Enum>
Enum named_option(const std::string& text, const std::string& option) {
  if (const auto value = value_of<Enum>(text)) return *value;
  throw Error(fmt::format("{} = \"{}\" {}", option, text, must_be_one_of(enum_names<Enum>, text)));
}

inline Precision precision_option(const std::string& text) {
  return named_option<Precision>(text, "--precision");
}

}  // namespace polhode::cli
