// SPDX-License-Identifier: MIT
// The allowed ranges of force field settings.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "polhode/forces/laws/settings.hpp"

namespace polhode {

/// A force setting outside its allowed range.
struct SettingFault {
  std::string_view key;   ///< name of the setting in run files, such as "switch"
  std::string value;      ///< value with its unit, such as "0.9 nm"
  std::string complaint;  ///< description of the error, such as "must be shorter than ..."

  std::string message() const;  ///< The complete message: "switch = 0.9 nm must be shorter than
                                ///< ...".
};

/// The first setting outside its allowed range; empty if all are valid.
std::optional<SettingFault> find_fault(const ForceSettings& settings);

/// Returns the settings after checking them.
/// @throws Error  if a setting is outside its domain
const ForceSettings& checked(const ForceSettings& settings);

}  // namespace polhode
