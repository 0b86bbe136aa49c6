// SPDX-License-Identifier: MIT
#include "setting_rows.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/suggest.hpp"
#include "io/settings/ensemble_names.hpp"
#include "polhode/base/error.hpp"

namespace polhode {
namespace {

/// The value of a key, read as the kind of its row; empty if the key is absent.
SettingValue read_value(TomlTable& table, const SettingRow& row) {
  const auto found = [](const auto& value) {
    return value ? SettingValue(*value) : SettingValue{};
  };
  if (row.unit.dimension) return found(table.quantity(row.key, *row.unit.dimension, example(row)));
  switch (row.member.kind) {
    case SettingKind::number:
      return found(table.number(row.key));
    case SettingKind::integer:
      return found(table.integer(row.key));
    case SettingKind::boolean:
      return found(table.boolean(row.key));
    case SettingKind::texts:
      return found(table.texts(row.key));
    default:
      return found(table.text(row.key));
  }
}

std::optional<double> number_of(const SettingValue& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
  if (const auto* number = std::get_if<double>(&value)) return *number;
  return std::nullopt;
}

void check_value(const TomlTable& table, const SettingRow& row, const SettingValue& value) {
  if (const auto* text = std::get_if<std::string>(&value); text && !row.member.names.empty())
    if (const auto& names = row.member.names;
        std::find(names.begin(), names.end(), *text) == names.end())
      table.refuse(row.key, must_be_one_of(names, *text));
  if (const auto number = number_of(value); number && !row.bounds.in_library)
    table.require(is_valid(row, *number), row.key, complaint(row));
}

std::vector<SettingTable> all_tables() {
  std::vector<SettingTable> tables{system_table(),     forces_table(),
                                   integrator_table(), run_table(),
                                   prepare_table(),    output_table(),
                                   study_table(),      thermostat_table(),
                                   barostat_table(),   hybrid_monte_carlo_table()};
  for (SettingTable& table : tables)
    for (SettingRow& row : table.rows) row.table = table.name;
  return tables;
}

}  // namespace

const std::vector<SettingTable>& setting_tables() {
  static const std::vector<SettingTable> tables = all_tables();
  return tables;
}

std::string example(const SettingRow& row) {
  if (!row.unit.example.empty()) return std::string(row.unit.example);
  const std::string text = text_of(row, defaults_with(row));
  return text.empty() ? fmt::format("1 {}", row.unit.symbol) : text;
}

const SettingTable& setting_table(std::string_view name) {
  const auto& tables = setting_tables();
  return *std::find_if(tables.begin(), tables.end(),
                       [&](const SettingTable& table) { return table.name == name; });
}

const SettingRow& setting_row(std::string_view table, std::string_view key) {
  const auto& rows = setting_table(table).rows;
  return *std::find_if(rows.begin(), rows.end(),
                       [&](const SettingRow& row) { return row.key == key; });
}

void read_row(TomlTable& table, const SettingRow& row, Config& config) {
  const SettingValue value = read_value(table, row);
  if (std::holds_alternative<std::monostate>(value)) return;
  check_value(table, row, value);
  row.member.set(config, value);
}

void read_table(TomlTable table, const SettingTable& rows, Config& config) {
  for (const SettingRow& row : rows.rows)
    if (table.has(row.key))
      config.given[fmt::format("{}.{}", rows.name, row.key)] = {table.written(row.key),
                                                                table.where(row.key)};
  if (rows.before) rows.before(table, config);
  for (const SettingRow& row : rows.rows) {
    if (row.more.by.empty() || row.member.exists(config)) {
      (row.more.read ? row.more.read : read_row)(table, row, config);
      continue;
    }
    table.require(!table.has(row.key), row.key,
                  fmt::format("has no meaning without {} = \"{}\"; leave it out", row.more.by,
                              fmt::join(deciding_names(row), "\" or \"")));
  }
  if (rows.after) rows.after(table, config);
  table.refuse_unknown();
}

bool is_valid(const SettingRow& row, double value) {
  SettingBounds bounds = row.bounds;
  bounds.min *= row.unit.factor();
  bounds.max *= row.unit.factor();
  return bounds.hold(value) && (std::isfinite(value) || row.bounds.in_library);
}

std::string tidy_exponent(std::string number) {
  if (const auto e = number.find('e'); e != number.npos && e + 3 < number.size()) {
    if (number[e + 2] == '0') number.erase(e + 2, 1);
    if (number[e + 1] == '+') number.erase(e + 1, 1);
  }
  return number;
}

std::string short_number(const SettingRow& row, double value) {
  const std::string number = tidy_exponent(fmt::format("{:g}", value));
  return fmt::format("{}{}{}", number, row.unit.dimension ? " " : "", row.unit.symbol);
}

std::string complaint(const SettingRow& row) {
  const bool long_or_above = row.unit.dimension == Dimension::time ||
                             row.unit.dimension == Dimension::wall_clock ||
                             row.unit.dimension == Dimension::length;
  const auto number = [&](double value) { return short_number(row, value); };
  const SettingBounds& b = row.bounds;
  std::string text = "must be ";
  if (std::isfinite(b.min))
    text += b.above ? fmt::format("{} {}", long_or_above ? "longer than" : "above", number(b.min))
                    : fmt::format("{} or {}", number(b.min), long_or_above ? "longer" : "more");
  if (std::isfinite(b.max))
    text += fmt::format("{}{} {}", std::isfinite(b.min) ? " and " : "",
                        b.below ? "below" : "at most", number(b.max));
  return text + std::string(b.hint);
}

std::string wrong_value(const SettingRow& row, const Config& config) {
  if (!row.member.exists || !row.member.exists(config)) return "";
  const auto number = number_of(row.member.value(config));
  return !number || is_valid(row, *number) ? "" : complaint(row);
}

std::string text_of(const SettingRow& row, const Config& config) {
  if (!row.member.exists || !row.member.exists(config)) return "";
  const SettingValue value = row.member.value(config);
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return fmt::format("{}", *whole);
  if (const auto* list = std::get_if<std::vector<std::string>>(&value))
    return fmt::format("{}", fmt::join(*list, ", "));
  if (const auto* number = std::get_if<double>(&value))
    return row.unit.dimension
               ? fmt::format("{:.12g} {}", *number / row.unit.factor(), row.unit.symbol)
               : fmt::format("{}", *number);
  return std::string(row.more.not_set);
}

const Config& defaults() {
  static const Config config = [] {
    Config made;
    made.ensemble.thermostat.emplace();
    made.ensemble.barostat = default_barostat();
    made.ensemble.hybrid_monte_carlo.emplace();
    return made;
  }();
  return config;
}

Config defaults_with(const SettingRow& row) {
  Config config = defaults();
  if (const auto names = deciding_names(row); !names.empty())
    setting_row(row.table, row.more.by).member.set(config, names.front());
  return config;
}

std::vector<std::string> deciding_names(const SettingRow& row) {
  std::vector<std::string> names;
  if (row.more.by.empty()) return names;
  const SettingMember& deciding = setting_row(row.table, row.more.by).member;
  for (const std::string_view name : deciding.names) {
    Config config = defaults();
    deciding.set(config, std::string(name));
    if (row.member.exists(config)) names.emplace_back(name);
  }
  return names;
}

}  // namespace polhode
