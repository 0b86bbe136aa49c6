// SPDX-License-Identifier: MIT
// The settings of run files as text and as JSON.
#pragma once

#include <string>

#include "polhode/io/settings/config.hpp"

namespace polhode {

/// Settings with values in a run, defaults and meanings.
/// @param name    path or key of a setting, or a table; empty for all settings
/// @param config  configuration whose values are listed; null to list no values
/// @throws Error  if the setting or table does not exist; the message gives the most similar names
std::string settings_text(const std::string& name, const Config* config);

/// Settings with their values, defaults and meanings, as a JSON array.
std::string settings_json(const std::string& name, const Config* config);

}  // namespace polhode
