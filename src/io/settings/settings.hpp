// SPDX-License-Identifier: MIT
// The settings of run files as data: for help texts, the manual, listings and other front ends.
// Each setting is a row in src/io/settings/*_rows.cpp.
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

/// The bounds of a number, in the unit of the setting.
struct SettingBounds {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool above = false;       ///< whether `min` is excluded
  bool below = false;       ///< whether `max` is excluded
  std::string_view hint{};  ///< text after "must be ...", with a reason or a usual value
  /// Whether the library checks the bounds later, because the check needs more information.
  bool in_library = false;

  bool hold(double value) const {
    return (above ? value > min : value >= min) && (below ? value < max : value <= max);
  }
};

/// The description of a setting for manuals and help texts.
struct Setting {
  std::string table, key;
  std::vector<SettingKind> kinds;     ///< kinds that the value of the setting may have
  std::string unit;                   ///< unit of a quantity; empty for other kinds
  std::string domain;                 ///< values and bounds, such as "temperature ≥ 0 K"
  std::string fallback;               ///< default value, possibly in words; empty if there is none
  std::string example;                ///< "2 fs", or the names of all values; may be empty
  SettingBounds bounds;               ///< bounds of numbers
  std::string by;                     ///< key that decides whether the setting applies
  std::vector<std::string> by_names;  ///< values of `by` for which it applies; empty: all
  std::string doc;                    ///< meaning, in Markdown with links of the manual

  std::string path() const { return table + '.' + key; }
};

/// The name of a table, or of a list of tables, in run files.
struct SettingTableName {
  std::string_view name;
  SettingKind kind;
};

/// All tables of run files, in the order in which they are read.
const std::vector<SettingTableName>& setting_table_names();

/// All settings, table by table. Keys within lists of tables and the names of schemes are not
/// included.
const std::vector<Setting>& settings();

/// Finds a setting by its path, such as "run.length", or by its key if this key occurs in a single
/// table.
/// @throws Error  if no setting matches (the message gives the most similar names), or if several
///   tables have the key
const Setting& setting(std::string_view path);

/// The value of a setting in a run as text, such as "2 fs", or "4" for a number. The text is empty
/// if the setting does not apply to the run, or if the default depends on more than the settings.
std::string value_text(const Setting& setting, const Config& config);

/// A description of what is wrong with a setting's value, which is in internal units; empty if the
/// value is valid.
std::string wrong_value(std::string_view path, double value);

/// Paths and values of the settings that determine a run, such as "thermostat.friction" and "1
/// 1/ps". Only the given tables are included, or all tables if none is given.
std::vector<std::pair<std::string, std::string>> recorded_settings(
    const Config& config, const std::vector<std::string_view>& tables = {});

/// The meaning of a setting without Markdown links and markup.
std::string plain_text(std::string_view markdown);

/// The meaning of a setting in a few words, with its values or an example, for help texts.
std::string brief_meaning(const Setting& setting);

/// The table of the manual that lists the settings of a run-file table, with columns for key,
/// values and bounds, default and meaning.
std::string manual_table(std::string_view table);

}  // namespace polhode
