// SPDX-License-Identifier: MIT
#include "io/settings/settings.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/suggest.hpp"
#include "polhode/base/error.hpp"
#include "setting_rows.hpp"

namespace polhode {
namespace {

/// A number or name in code font, as in the tables of the manual.
std::string code(std::string_view text) { return fmt::format("`\"{}\"`", text); }

std::vector<SettingKind> kinds_of(const SettingRow& row) {
  if (!row.more.kinds.empty()) return row.more.kinds;
  return {row.unit.dimension ? SettingKind::quantity : row.member.kind};
}

/// The domain of a setting as text, such as "temperature ≥ 0 K", "`true`, `false`" or "list of
/// texts".
std::string domain_of(const SettingRow& row) {
  if (!row.more.domain.empty()) return std::string(row.more.domain);
  if (!row.member.names.empty()) {
    std::vector<std::string> names;
    for (const std::string_view name : row.member.names) names.push_back(code(name));
    return fmt::format("{}", fmt::join(names, ", "));
  }
  const auto number = [&](double value) { return short_number(row, value); };
  switch (kinds_of(row).front()) {
    case SettingKind::boolean:
      return "`true`, `false`";
    case SettingKind::texts:
      return "list of texts";
    case SettingKind::text:
      return "text";
    default:
      break;
  }
  const SettingBounds& b = row.bounds;
  const std::string_view word = row.unit.dimension ? noun(*row.unit.dimension)
                                : row.member.kind == SettingKind::integer ? "whole number"
                                                                          : "number";
  if (std::isfinite(b.min) && !std::isfinite(b.max))
    return fmt::format("{} {} {}", word, b.above ? ">" : "≥", number(b.min));
  return (std::isfinite(b.min) ? number(b.min) + (b.above ? " < " : " ≤ ") : "") +
         std::string(word) +
         (std::isfinite(b.max) ? (b.below ? " < " : " ≤ ") + number(b.max) : "");
}

/// The default as written in a run file, such as `"2 fs"`, or in words; empty if there is none.
std::string fallback_of(const SettingRow& row) {
  if (!row.more.fallback.empty()) return std::string(row.more.fallback);
  if (!row.member.value) return "";
  const Config config = defaults_with(row);
  const SettingValue value = row.member.value(config);
  if (std::holds_alternative<std::monostate>(value)) return "";
  if (const auto* list = std::get_if<std::vector<std::string>>(&value))
    return list->empty() ? "" : fmt::format("`[\"{}\"]`", fmt::join(*list, "\", \""));
  const std::string text = tidy_exponent(text_of(row, config));
  if (text.empty()) return "";
  return row.unit.dimension || std::holds_alternative<std::string>(value) ? code(text)
                                                                          : "`" + text + "`";
}

/// An example for help: all names, or a quantity with the quotes of a command line, such as "2 fs".
std::string example_of(const SettingRow& row) {
  if (!row.member.names.empty()) return fmt::format("{}", fmt::join(row.member.names, ", "));
  return row.unit.dimension ? fmt::format("\"{}\"", example(row)) : "";
}

std::string doc_of(const SettingRow& row) {
  const auto names = deciding_names(row);
  if (names.empty()) return std::string(row.doc);
  std::vector<std::string> marked;
  for (const std::string& name : names) marked.push_back(code(name));
  return fmt::format("{}; only with {} {}", row.doc, row.more.by, fmt::join(marked, ", "));
}

std::vector<Setting> all_settings() {
  std::vector<Setting> all;
  for (const SettingTable& table : setting_tables())
    for (const SettingRow& row : table.rows)
      all.push_back({std::string(table.name), std::string(row.key), kinds_of(row),
                     std::string(row.unit.symbol), domain_of(row), fallback_of(row),
                     example_of(row), row.bounds, std::string(row.more.by), deciding_names(row),
                     doc_of(row)});
  return all;
}

}  // namespace

const std::vector<SettingTableName>& setting_table_names() {
  static const std::vector<SettingTableName> names = [] {
    std::vector<SettingTableName> all;
    for (const SettingTable& table : setting_tables()) {
      all.push_back({table.name, SettingKind::table});
      if (table.name == "system") all.push_back({"shape", SettingKind::tables});
      if (table.name == "forces")
        all.insert(all.end(), {{"pair", SettingKind::tables}, {"schemes", SettingKind::table}});
    }
    return all;
  }();
  return names;
}

const std::vector<Setting>& settings() {
  static const std::vector<Setting> all = all_settings();
  return all;
}

const Setting& setting(std::string_view path) {
  std::vector<const Setting*> found;
  std::vector<std::string> names;
  for (const Setting& one : settings()) {
    if (one.path() == path || one.key == path) found.push_back(&one);
    names.insert(names.end(), {one.path(), one.key});
  }
  if (found.size() == 1) return *found.front();
  if (found.empty())
    throw Error(fmt::format("there is no setting '{}'{}", path, did_you_mean(path, names)));
  std::vector<std::string> paths;
  for (const Setting* one : found) paths.push_back(one->path());
  throw Error(
      fmt::format("several tables have the key '{}'; give one of: {}", path, join_names(paths)));
}

std::string value_text(const Setting& setting, const Config& config) {
  const SettingRow& row = setting_row(setting.table, setting.key);
  if (row.member.value) return text_of(row, config);
  const auto given = config.given.find(setting.path());
  return given == config.given.end() ? "" : given->second.value;
}

std::string wrong_value(std::string_view path, double value) {
  const auto dot = path.find('.');
  const SettingRow& row = setting_row(path.substr(0, dot), path.substr(dot + 1));
  return is_valid(row, value) ? "" : complaint(row);
}

std::vector<std::pair<std::string, std::string>> recorded_settings(
    const Config& config, const std::vector<std::string_view>& tables) {
  std::vector<std::pair<std::string, std::string>> texts;
  for (const SettingTable& table : setting_tables()) {
    if (!tables.empty() && std::find(tables.begin(), tables.end(), table.name) == tables.end())
      continue;
    for (const SettingRow& row : table.rows)
      if (const std::string text = row.more.free ? "" : text_of(row, config); !text.empty())
        texts.emplace_back(fmt::format("{}.{}", table.name, row.key), text);
  }
  return texts;
}

std::string plain_text(std::string_view markdown) {
  std::string text;
  for (std::size_t k = 0; k < markdown.size(); ++k) {
    if (markdown[k] == ']' && markdown.substr(k + 1, 1) == "(")
      k = markdown.find(')', k);
    else if (markdown[k] != '`' && !(markdown[k] == '[' && markdown[k + 1] != '"'))
      text += markdown[k];
  }
  return text;
}

std::string brief_meaning(const Setting& setting) {
  const std::string meaning = plain_text(setting.doc);
  const std::string brief = meaning.substr(0, meaning.find_first_of(":;"));
  return setting.example.empty() ? brief : brief + ": " + setting.example;
}

std::string manual_table(std::string_view table) {
  std::string text = "| key | value, domain | default | meaning |\n| --- | --- | --- | --- |\n";
  for (const Setting& one : settings())
    if (one.table == table)
      text += fmt::format("| `{}` | {} | {} | {} |\n", one.key, one.domain, one.fallback, one.doc);
  return text;
}

}  // namespace polhode
