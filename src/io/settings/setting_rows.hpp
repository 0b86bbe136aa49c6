// SPDX-License-Identifier: MIT
// The table of settings, one row each: its key, its member, and all from which reading, checks,
// identity, manual and help follow. The default is the initialiser of the member.
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

/// The unit in which texts state a quantity; none: a pure number, or no number.
struct SettingUnit {
  std::optional<Dimension> dimension{};
  std::string_view symbol{};
  std::string_view example{};  ///< in errors, if the default is none

  double factor() const { return dimension ? unit(symbol, *dimension) : 1; }
};

struct SettingRow;
using ReadSetting = void (*)(TomlTable&, const SettingRow&, Config&);

/// What only some rows have.
struct More {
  std::string_view domain{};    ///< in words, where kind and bounds do not tell
  std::string_view fallback{};  ///< the default in words, where it depends on other settings
  std::string_view by{};        ///< the key whose value decides whether this one has a meaning
  std::string_view not_set = "none";  ///< the text of a value that is not set
  ReadSetting read = nullptr;         ///< in place of read_row()
  bool free = false;                  ///< a resumed run may have another value
  std::vector<SettingKind> kinds{};   ///< where the member does not tell
};

struct SettingRow {
  std::string_view key;
  SettingMember member;
  SettingUnit unit{};
  SettingBounds bounds{};
  std::string_view doc{};  ///< its meaning, in Markdown with the links of the manual
  More more{};
  std::string_view table{};  ///< set by setting_tables()
};

namespace detail {

inline void set(SettingRow& row, SettingMember member) { row.member = std::move(member); }
inline void set(SettingRow& row, const SettingUnit& unit) { row.unit = unit; }
inline void set(SettingRow& row, const SettingBounds& bounds) { row.bounds = bounds; }
inline void set(SettingRow& row, const char* doc) { row.doc = doc; }
inline void set(SettingRow& row, More more) { row.more = std::move(more); }

}  // namespace detail

/// A row: its key, and what it has of member, unit, bounds, meaning and more.
template <class... Parts>
SettingRow row(std::string_view key, Parts... parts) {
  SettingRow made{key, {}};
  (detail::set(made, std::move(parts)), ...);
  return made;
}

struct SettingTable {
  std::string_view name;
  std::vector<SettingRow> rows;
  void (*before)(TomlTable&, Config&) = nullptr;  ///< reading its rows
  void (*after)(TomlTable&, Config&) = nullptr;
};

SettingTable system_table();
SettingTable forces_table();
SettingTable integrator_table();
SettingTable run_table();
SettingTable prepare_table();
SettingTable output_table();
SettingTable study_table();
SettingTable thermostat_table();
SettingTable barostat_table();
SettingTable hybrid_monte_carlo_table();

const std::vector<SettingTable>& setting_tables();
const SettingTable& setting_table(std::string_view name);
const SettingRow& setting_row(std::string_view table, std::string_view key);

/// Reads a table: all its rows, then nothing else may be left.
void read_table(TomlTable table, const SettingTable& rows, Config& config);

/// Reads one setting as its kind, unit and bounds say; an absent key leaves the default.
void read_row(TomlTable& table, const SettingRow& row, Config& config);

/// The reader of a setting that the functions of its table read.
inline void read_by_table(TomlTable&, const SettingRow&, Config&) {}

/// Whether a value in internal units is within the bounds, and finite.
bool is_valid(const SettingRow& row, double value);

/// "4.5e-5" for "4.5e-05".
std::string tidy_exponent(std::string number);
/// A number in its shortest form, "1e12".
std::string short_number(double value);

/// A quantity as a text, for errors and help: the example of the row, or its default.
std::string example(const SettingRow& row);

/// "must be 0 K or more, ...".
std::string complaint(const SettingRow& row);

/// What is wrong with its value in a run; empty if nothing.
std::string wrong_value(const SettingRow& row, const Config& config);

/// Its value in a run as text, "2 fs"; empty if the run has no use for it.
std::string text_of(const SettingRow& row, const Config& config);

/// A run with all tables, whose members have their defaults.
const Config& defaults();

/// A run that has a use for the setting; all members have their defaults.
Config defaults_with(const SettingRow& row);

/// Those values of the deciding key for which a setting has a meaning, as names; empty: all.
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
