// SPDX-License-Identifier: MIT
// The settings of run files as text and as JSON.
#pragma once

#include <string>

#include "polhode/io/settings/config.hpp"

namespace polhode {

/// Settings with their values in a run, their defaults and meanings.
/// @param name    path or key of a setting, or a table; empty: all
/// @param config  whose values to state; null: none
/// @throws Error  if there is no such setting or table, with the nearest names
std::string settings_text(const std::string& name, const Config* config);

/// The same as a JSON array.
std::string settings_json(const std::string& name, const Config* config);

}  // namespace polhode
