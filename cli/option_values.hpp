// SPDX-License-Identifier: MIT
// Parsing of option values.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "polhode/integrate/nested_scheme.hpp"
#include "polhode/io/config.hpp"
#include "polhode/io/quantity.hpp"
#include "polhode/run/outputs.hpp"

namespace polhode::cli {

/// Converts "2 fs" to ps.
/// @throws Error  if the unit is missing or the time is not positive
double positive_time(const std::string& text, const std::string& option);

/// The command as it could be typed, without empty options.
std::string typed_command(std::string command,
                          const std::vector<std::pair<std::string, std::string>>& options);

/// The scheme of a name or a text, nested or not.
/// @throws Error  naming the option, if there is no such scheme
NestedScheme scheme_option(const std::string& text, const std::string& option);

/// "double" or "mixed".
/// @throws Error  for any other word
Precision precision_option(const std::string& text);

/// The run file of a path, or the default one, with a precision in place of its own if it is given.
/// @throws Error  as read_config() and precision_option()
Config read_config_option(const std::string& file, const std::string& precision = {});

/// What --continue and --force say of files that exist.
/// @throws Error  if both are given
ExistingFiles existing_files(bool resume, bool force);

}  // namespace polhode::cli
