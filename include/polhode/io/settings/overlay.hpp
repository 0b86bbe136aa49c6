// SPDX-License-Identifier: MIT
// Settings from a command line or from keywords, which override the settings of a run file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace polhode {

/// A setting that overrides the run file. The value of the override is parsed according to the key.
struct Override {
  std::string key;                  ///< key such as "integrator.step", or a list of tables: "pair"
  std::vector<std::string> values;  ///< value as text, such as "4"; for a list, one per element
  std::string place;                ///< option for error messages, such as "--step"
  std::string toml{};               ///< value as written in a run file; if empty, `values` is used
};

struct Overlay {
  std::vector<Override> settings;  ///< overrides; the last setting of a key has precedence
  /// Whether a setting of the pressure also selects a thermostat, if the run file has neither a
  /// thermostat nor hybrid Monte Carlo.
  bool pressure_selects_thermostat = true;

  /// The last override of a key, or null if there is none.
  const Override* find(std::string_view key) const;
};

}  // namespace polhode
