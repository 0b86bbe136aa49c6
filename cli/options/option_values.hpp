// SPDX-License-Identifier: MIT
// Parsing of option values.
#pragma once

#include <fmt/core.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "base/suggest.hpp"
#include "forces/laws/setting_names.hpp"
#include "io/settings/quantity.hpp"
#include "polhode/base/error.hpp"
#include "polhode/io/settings/config.hpp"
#include "polhode/run/outputs.hpp"

namespace polhode::cli {

/// Converts "2 fs" to ps.
/// @throws Error  if the unit is missing or the time is not positive
double positive_time(const std::string& text, const std::string& option);

/// Converts "5 ps" to ps.
/// @throws Error  if the unit is missing or the time is negative
double time_option(const std::string& text, const std::string& option);

/// Sets a time if its option is given.
/// @throws Error  as positive_time()
void set_time(double& time, const std::string& text, const std::string& option);

/// The times in ascending order.
/// @throws Error  as positive_time()
std::vector<double> sorted_times(const std::vector<std::string>& texts, const std::string& option);

/// A time for help texts: "2 ps", "20 fs".
std::string time_text(double time);

/// Sets names or texts of schemes if their option is given.
/// @param own  those of the run file, which may be given by name
/// @throws Error  as scheme_option()
void set_schemes(std::vector<NamedScheme>& schemes, const std::vector<std::string>& texts,
                 const std::string& option, const OwnSchemes& own);

/// The command as it could be typed, without empty options.
std::string typed_command(std::string command,
                          const std::vector<std::pair<std::string, std::string>>& options);

/// A scheme, with the texts of the run file's own schemes in place of their names.
/// @throws Error  naming the option, if there is no such scheme
NamedScheme scheme_option(const std::string& text, const std::string& option,
                          const OwnSchemes& own);

/// The value of a named enumeration.
/// @throws Error  for any word that is not a name
template <NamedEnum Enum>
Enum named_option(const std::string& text, const std::string& option) {
  if (const auto value = value_of<Enum>(text)) return *value;
  throw Error(fmt::format("{} = \"{}\" {}", option, text, must_be_one_of(enum_names<Enum>, text)));
}

/// The run file of a path, or the default one, with a precision instead of its own if one is given.
/// @throws Error  as read_config(); naming --precision
Config read_config_option(const std::string& file, const std::string& precision = {});

/// The number, from 0 to max.
/// @param remedy  what to do, for the error
/// @throws Error  naming the option, unless the text is such a number
std::uint64_t whole_number(const std::string& text, const std::string& option, std::uint64_t max,
                           const std::string& remedy);

/// Applies --temperature and --seed, each unless it is empty.
/// @throws Error  naming the option, if the temperature is wrong_temperature(), or the seed is not
///                a whole number from 0
void set_initial_motion(Config& config, const std::string& temperature, const std::string& seed);

/// What --continue and --force do with files that exist.
/// @throws Error  if both are given
ExistingFiles existing_files(bool resume, bool force);

}  // namespace polhode::cli
