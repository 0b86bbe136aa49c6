// SPDX-License-Identifier: MIT
// The tables and keys of run files, as their readers ask for them: for front ends that list them.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "polhode/base/enum_names.hpp"

namespace polhode {

enum class SettingKind : std::uint8_t {
  text,
  quantity,  ///< a text with a unit
  number,
  integer,
  boolean,
  texts,  ///< a list of texts
  table,
  tables  ///< a list of tables
};

template <>
inline constexpr std::array<std::string_view, 8> enum_names<SettingKind> = {
    "text", "quantity", "number", "integer", "boolean", "texts", "table", "tables"};

struct SettingKey {
  std::string table;  ///< empty for a table of its own, such as "system"
  std::string key;
  std::vector<SettingKind> kinds;  ///< that its value may have
};

/// All keys of run files, in the order in which they are read: what parse_config() asks for.
/// Without the keys within lists of tables, and the names of schemes.
std::vector<SettingKey> setting_keys();

}  // namespace polhode
