// SPDX-License-Identifier: MIT
// Settings from a command line or from keywords, which override those of a run file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace polhode {

/// A setting with its value, which is read as its key expects.
struct Override {
  std::string key;                  ///< "integrator.step", or a list of tables: "pair"
  std::vector<std::string> values;  ///< a text, also of a number, "4", or the texts of a list
  std::string place;                ///< the option that has it, "--step", for errors
  std::string toml{};               ///< the value as in a run file; empty: the texts are it
};

struct Overlay {
  std::vector<Override> settings;  ///< overrides; the last one of a key has precedence
  /// Whether a pressure selects a thermostat where the run file has neither one nor hybrid Monte
  /// Carlo.
  bool pressure_selects_thermostat = true;

  /// The last override of a key; null: none.
  const Override* find(std::string_view key) const;
};

/// The text of a run file with an overlay in it.
/// @throws Error  as parse_config(), but only for what no run file can have
std::string overlaid_text(std::string_view text, const std::string& file, const Overlay& overlay);

}  // namespace polhode
