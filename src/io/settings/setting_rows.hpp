// SPDX-License-Identifier: MIT
// The table of settings, one row for each setting. A row has the key, the member of the Config, and
// the data with which the setting is read, checked, compared between runs, and documented. The
// default of a setting is the initialiser of its member.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/settings/quantity.hpp"
#include "setting_member.hpp"
#include "toml_table.hpp"

namespace polhode {

/// The unit in which a quantity is written; empty for a pure number, or if the setting is not a
/// number.
struct SettingUnit {
  std::optional<Dimension> dimension{};
  std::string_view symbol{};
  std::string_view example{};  ///< example in error messages of a setting without default

  double factor() const { return dimension ? unit(symbol, *dimension) : 1; }
};

struct SettingRow;
using ReadSetting = void (*)(TomlTable&, const SettingRow&, Config&);

/// Properties that only some rows have.
struct More {
  std::string_view domain{};          ///< domain in words, if kind and bounds do not describe it
  std::string_view fallback{};        ///< default in words, if other settings affect it
  std::string_view by{};              ///< key that decides whether this setting applies
  std::string_view not_set = "none";  ///< text that stands for a missing value
  ReadSetting read = nullptr;         ///< function that replaces read_row()
  bool free = false;                  ///< whether a resumed run may have a different value
  std::vector<SettingKind> kinds{};   ///< kinds of values, if the member does not determine them
};

struct SettingRow {
  std::string_view key;
  SettingMember member;
  SettingUnit unit{};
  SettingBounds bounds{};
  std::string_view doc{};  ///< meaning of the setting, in Markdown with the links of the manual
  More more{};
  std::string_view table{};  ///< name of the table, set by setting_tables()
};

namespace setting_detail {

inline void set(SettingRow& row, SettingMember member) { row.member = std::move(member); }
inline void set(SettingRow& row, const SettingUnit& unit) { row.unit = unit; }
inline void set(SettingRow& row, const SettingBounds& bounds) { row.bounds = bounds; }
inline void set(SettingRow& row, const char* doc) { row.doc = doc; }
inline void set(SettingRow& row, More more) { row.more = std::move(more); }

}  // namespace setting_detail

/// Makes a row from its key and any of the following: member, unit, bounds, meaning, and More.
template <class... Parts>
SettingRow row(std::string_view key, Parts... parts) {
  SettingRow made{key, {}};
  (setting_detail::set(made, std::move(parts)), ...);
  return made;
}

struct SettingTable {
  std::string_view name;
  std::vector<SettingRow> rows;
  void (*before)(TomlTable&, Config&) = nullptr;  ///< called before the rows are read
  void (*after)(TomlTable&, Config&) = nullptr;
};

SettingTable system_table(), forces_table(), integrator_table(), run_table(), prepare_table(),
    output_table(), study_table(), thermostat_table(), barostat_table(), hybrid_monte_carlo_table();

const std::vector<SettingTable>& setting_tables();
const SettingTable& setting_table(std::string_view name);
const SettingRow& setting_row(std::string_view table, std::string_view key);

/// Reads all rows of a table. The table must not contain other keys.
void read_table(TomlTable table, const SettingTable& rows, Config& config);

/// Reads one setting according to its kind, unit and bounds. If the key is absent, the setting
/// keeps its default.
void read_row(TomlTable& table, const SettingRow& row, Config& config);

/// A function that reads nothing, for settings that another function of their table reads.
inline void read_by_table(TomlTable&, const SettingRow&, Config&) {}

/// Whether a value in internal units is finite and within the bounds of its row.
bool is_valid(const SettingRow& row, double value);

/// Simplifies the exponent of a number: "4.5e-5" instead of "4.5e-05".
std::string tidy_exponent(std::string number);
/// A number in its shortest form, with the unit of the row: "1e12 ps".
std::string short_number(const SettingRow& row, double value);

/// A quantity as text, for error messages and help: the default of the row or, without a default,
/// its example.
std::string example(const SettingRow& row);

/// The complaint about an invalid value, such as "must be 0 K or more, ...".
std::string complaint(const SettingRow& row);

/// A description of the error in the value of a setting; empty if the value is valid.
std::string wrong_value(const SettingRow& row, const Config& config);

/// The value of a setting in a run as text, such as "2 fs"; empty if the setting does not apply to
/// the run.
std::string text_of(const SettingRow& row, const Config& config);

/// A configuration with all tables. All members have their defaults.
const Config& defaults();

/// A configuration in which the setting applies, and all members have their defaults.
Config defaults_with(const SettingRow& row);

/// The values of the deciding key, as names, for which a setting applies; empty if the setting
/// applies for all values.
std::vector<std::string> deciding_names(const SettingRow& row);

constexpr SettingBounds above(double min, std::string_view hint = {}) {
  return {.min = min, .above = true, .hint = hint};
}
constexpr SettingBounds from(double min, std::string_view hint = {}) {
  return {.min = min, .hint = hint};
}
constexpr SettingBounds between(double min, double max, std::string_view hint = {}) {
  return {.min = min, .max = max, .hint = hint};
}
constexpr SettingBounds above_to(double min, double max, std::string_view hint = {}) {
  return {.min = min, .max = max, .above = true, .hint = hint};
}

}  // namespace polhode
