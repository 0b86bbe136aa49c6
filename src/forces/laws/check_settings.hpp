// SPDX-License-Identifier: MIT
// The domains of force field settings.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "polhode/forces/laws/settings.hpp"

namespace polhode {

/// A setting outside its domain.
struct SettingFault {
  std::string_view key;   ///< its name in run files: "switch"
  std::string value;      ///< "0.9 nm"
  std::string complaint;  ///< "must be shorter than ..."

  std::string message() const;  ///< "switch = 0.9 nm must be shorter than ..."
};

/// The first setting outside its domain, if there is one.
std::optional<SettingFault> find_fault(const ForceSettings& settings);

/// Returns the settings.
/// @throws Error  if one of them is outside its domain
const ForceSettings& checked(const ForceSettings& settings);

}  // namespace polhode
