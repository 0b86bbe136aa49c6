// SPDX-License-Identifier: MIT
// The settings of run files as data: for help texts, the manual, listings and other front ends.
// Each is one row of src/io/settings/*_rows.cpp.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "polhode/base/enum_names.hpp"

namespace polhode {

struct Config;

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

/// From which number to which, in the unit of the setting.
struct SettingBounds {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool above = false;       ///< min itself is excluded
  bool below = false;       ///< max itself is excluded
  std::string_view hint{};  ///< after "must be ...": why, or what is usual
  /// Whether the library checks them itself, with more that it knows.
  bool in_library = false;

  bool hold(double value) const {
    return (above ? value > min : value >= min) && (below ? value < max : value <= max);
  }
};

/// A setting in words, as manuals and help texts show it.
struct Setting {
  std::string table, key;
  std::vector<SettingKind> kinds;     ///< that its value may have
  std::string unit;                   ///< in which texts state a quantity; empty for others
  std::string domain;                 ///< its values and bounds, "temperature ≥ 0 K"
  std::string fallback;               ///< its value if it is not given, or in words; empty: none
  std::string example;                ///< a value, "2 fs", or the names of all; empty for others
  SettingBounds bounds;               ///< of numbers
  std::string by;                     ///< the key whose value decides whether it has a meaning
  std::vector<std::string> by_names;  ///< for which values of that key it has one; empty: all
  std::string doc;                    ///< its meaning, in Markdown with the links of the manual

  std::string path() const { return table + '.' + key; }
};

/// A table of run files, or a list of tables.
struct SettingTableName {
  std::string_view name;
  SettingKind kind;
};

/// All tables of run files, in the order in which they are read.
const std::vector<SettingTableName>& setting_table_names();

/// All settings, table by table; without the keys within lists of tables, and the names of schemes.
const std::vector<Setting>& settings();

/// A setting by its path, such as "run.length", or by its key if only one table has it.
/// @throws Error  if there is none, with the nearest names, or if several tables have the key
const Setting& setting(std::string_view path);

/// Its value in a run as text, such as "2 fs", or "4" for a number. Empty if the run has no use for
/// it, or if its default depends on more than the settings.
std::string value_text(const Setting& setting, const Config& config);

/// What is wrong with a value of a setting in internal units; empty if nothing.
std::string wrong_value(std::string_view path, double value);

/// Key and value of each setting of some tables that a run depends on, such as
/// "thermostat.friction" and "1 1/ps"; of all tables if none is given.
std::vector<std::pair<std::string, std::string>> recorded_settings(
    const Config& config, const std::vector<std::string_view>& tables = {});

/// The meaning of a setting without the links and marks of Markdown.
std::string plain_text(std::string_view markdown);

/// The meaning of a setting in a few words, with its values or an example, for help texts.
std::string brief_meaning(const Setting& setting);

/// A table of the manual: key, values and bounds, default and meaning of the settings of a table.
std::string manual_table(std::string_view table);

}  // namespace polhode
