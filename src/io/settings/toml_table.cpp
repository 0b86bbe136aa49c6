// SPDX-License-Identifier: MIT
#include "toml_table.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <sstream>
#include <system_error>

#include "base/from_chars.hpp"
#include "base/suggest.hpp"
#include "polhode/base/error.hpp"

namespace polhode {

namespace {

// Maximum number of parts of a dotted key. The TOML library recurses into dotted keys without a
// limit, and into nested values up to a depth of 256. The stack must be large enough for the
// product of the depths of dotted keys and of nested values.
constexpr std::size_t max_dots = 8;

// The position of the end of the string that begins at a quote.
std::size_t end_of_string(std::string_view text, std::size_t begin) {
  const char quote = text[begin];
  const std::string_view three = text.substr(begin, 3);
  const bool many = three.size() == 3 && three[1] == quote && three[2] == quote;
  for (std::size_t k = begin + (many ? 3 : 1); k < text.size(); ++k) {
    if (quote == '"' && text[k] == '\\')
      ++k;
    else if (many ? text.substr(k, 3) == three : text[k] == quote)
      return k + (many ? 3 : 1);
    else if (!many && text[k] == '\n')
      return k;
  }
  return text.size();
}

// Rejects dotted keys with more parts than any run file needs.
void check_keys(std::string_view text, const std::string& file) {
  std::size_t dots = 0, line = 1;
  for (std::size_t k = 0; k < text.size();) {
    const char c = text[k];
    if (c == '"' || c == '\'') {
      const std::size_t end = end_of_string(text, k);
      line += static_cast<std::size_t>(std::count(text.begin() + static_cast<std::ptrdiff_t>(k),
                                                  text.begin() + static_cast<std::ptrdiff_t>(end),
                                                  '\n'));
      k = end;
      continue;
    }
    if (c == '#') {
      k = std::min(text.find('\n', k), text.size());
      continue;
    }
    if (c == '.' && ++dots > max_dots)
      throw Error(fmt::format("a key has more than {} dots, or tables are nested too deeply; "
                              "delete the key or the table",
                              max_dots),
                  fmt::format("{}:{}", file, line));
    if (std::string_view("=,[]{}\n").find(c) != std::string_view::npos) dots = 0;
    line += c == '\n';
    ++k;
  }
}

/// The message for an error that the TOML library reports, with advice.
std::string toml_complaint(const std::string& what) {
  if (const auto at = what.find("cannot redefine existing "); at != std::string::npos) {
    const auto open = what.find('\'', at), close = what.rfind('\'');
    if (open < close)
      return fmt::format("{} occurs twice, and only one of the two can apply; delete one of them",
                         what.substr(open, close - open + 1));
  }
  // All other control characters have been rejected already, so this control character is the end
  // of the line.
  if (what.find("parsing string") != what.npos &&
      (what.find("control characters") != what.npos || what.find("end-of-file") != what.npos))
    return "the text is not TOML: a text in quotes has no end on this line; close it with a "
           "quotation mark, as in step = "
           "\"2 fs\"";
  return fmt::format(
      "the text is not TOML: {}; quantities are written in quotes, as in step = \"2 fs\"",
      uncapitalized(what));
}

/// A TOML value as text, as in a file. Numbers have as many digits as necessary.
std::string source_text(const toml::node& node) {
  if (node.is_string()) return fmt::format("\"{}\"", *node.value<std::string>());
  if (node.is_floating_point()) return fmt::format("{}", *node.value<double>());
  std::ostringstream text;
  node.visit([&](const auto& n) { text << n; });
  return text.str();
}

}  // namespace

toml::table parse_toml(std::string_view text, const std::string& file) {
  check_keys(text, file);
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error& e) {
    throw Error(toml_complaint(std::string(e.description())),
                fmt::format("{}:{}", file, e.source().begin.line));
  }
}

const toml::node* TomlTable::find(std::string_view key) {
  if (std::find(asked_.begin(), asked_.end(), key) == asked_.end()) asked_.emplace_back(key);
  return table_->get(key);
}

std::vector<std::string> TomlTable::keys() const {
  std::vector<std::string> names;
  for (const auto& [key, node] : *table_) names.emplace_back(key.str());
  return names;
}

std::string TomlTable::full(std::string_view key) const {
  if (key.empty()) return path_;
  return path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key);
}

std::string TomlTable::written(std::string_view key) const {
  const toml::node* node = table_->get(key);
  return node != nullptr ? source_text(*node) : "";
}

const Override* TomlTable::override_of(std::string_view key) const {
  if (overlay_ == nullptr) return nullptr;
  const std::string path = full(key);
  const auto is_part = [](std::string_view part, std::string_view of) {
    return part.starts_with(of) &&
           (part.size() == of.size() || part[of.size()] == '.' || part[of.size()] == '[');
  };
  const auto& settings = overlay_->settings;
  const auto found = std::find_if(settings.rbegin(), settings.rend(), [&](const Override& one) {
    return is_part(path, one.key) || is_part(one.key, path);
  });
  return found == settings.rend() ? nullptr : &*found;
}

std::string TomlTable::where(std::string_view key) const {
  const toml::node* node = table_->get(key);
  const auto line = (node != nullptr ? node->source() : table_->source()).begin.line;
  if (line == 0)  // the value is not from the file
    if (const Override* const one = override_of(node != nullptr ? key : "")) return one->place;
  const std::string place = line > 0 ? fmt::format("{}:{}", file_, line) : file_;
  const std::string name = full(key);
  return name.empty() ? place : fmt::format("{}, {}", place, name);
}

void TomlTable::refuse(std::string_view key, const std::string& complaint) const {
  const toml::node* node = table_->get(key);
  if (node == nullptr) throw Error(complaint, where(key));
  throw Error(fmt::format("{} = {} {}", key, written(key), complaint), where(key));
}

void TomlTable::refuse_kind(std::string_view key, std::string_view must) const {
  refuse(key, fmt::format("must be {}", must));
}

std::string TomlTable::text_of(const toml::node& node, std::string_view key) const {
  if (!node.is_string()) refuse_kind(key, "a text in quotes");
  return *node.value<std::string>();
}

std::optional<std::string> TomlTable::text(std::string_view key) {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  return text_of(*node, key);
}

std::optional<double> TomlTable::quantity(std::string_view key, Dimension dimension,
                                          std::string_view example) {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  if (node->is_number()) throw Error(no_unit(key, written(key), dimension, example), where(key));
  const std::string words = text_of(*node, key);
  return at(key, [&] { return polhode::quantity(words, dimension, key, example); });
}

std::optional<Vec3<double>> TomlTable::vector(std::string_view key, Dimension dimension) {
  const auto words = text(key);
  if (!words) return std::nullopt;
  return at(key, [&] { return vector_quantity(*words, dimension, key); });
}

std::optional<double> TomlTable::number(std::string_view key) {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  if (!node->is_number()) refuse_kind(key, "a number without unit or quotes");
  const double value = *node->value<double>();
  if (!std::isfinite(value)) refuse_kind(key, "a finite number");
  return value;
}

std::optional<std::int64_t> TomlTable::integer(std::string_view key) {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  const Override* const one = override_of(key);
  if (one != nullptr && one->toml.empty() && node->is_string()) {
    const auto value = parsed_number<std::int64_t>(*node->value<std::string>());
    if (!value) refuse_kind(key, "a whole number");
    return value;
  }
  if (!node->is_integer()) refuse_kind(key, "a whole number without unit or quotes");
  return node->value<std::int64_t>();
}

std::optional<bool> TomlTable::boolean(std::string_view key) {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  if (!node->is_boolean()) refuse_kind(key, "true or false, without quotes");
  return node->value<bool>();
}

std::optional<std::vector<std::string>> TomlTable::texts(std::string_view key) {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  if (node->source().begin.line == 0 && node->is_string())  // the value is from an overlay
    return {{*node->value<std::string>()}};
  std::vector<std::string> values;
  const toml::array* list = node->as_array();
  if (list == nullptr) refuse_kind(key, "a list of texts, [\"...\", \"...\"]");
  for (const toml::node& entry : *list) {
    if (!entry.is_string()) refuse_kind(key, "a list of texts, each in quotes");
    values.push_back(*entry.value<std::string>());
  }
  return values;
}

std::optional<TomlTable> TomlTable::table(std::string_view key) {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  if (!node->is_table()) refuse_kind(key, fmt::format("a table, [{}]", full(key)));
  return TomlTable(*node->as_table(), file_, full(key), overlay_);
}

std::optional<std::vector<TomlTable>> TomlTable::tables(std::string_view key) {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  const toml::array* list = node->as_array();
  if (list == nullptr) refuse_kind(key, "a list of tables, [{ ... }, { ... }]");
  std::vector<TomlTable> values;
  for (const toml::node& entry : *list) {
    if (!entry.is_table()) refuse_kind(key, "a list of tables, [{ ... }, { ... }]");
    values.emplace_back(*entry.as_table(), file_, fmt::format("{}[{}]", full(key), values.size()),
                        overlay_);
  }
  return values;
}

bool TomlTable::holds_list(std::string_view key) {
  const toml::node* node = find(key);
  return node != nullptr && node->is_array();
}

bool TomlTable::holds_text(std::string_view key) {
  const toml::node* node = find(key);
  return node != nullptr && node->is_string();
}

void TomlTable::renamed(std::string_view old, std::string_view now) const {
  if (!table_->contains(old)) return;
  throw Error(
      fmt::format("the key '{0}' has been called '{1}' since version 0.2; write {1}", old, now),
      where(old));
}

void TomlTable::refuse_unknown() const {
  for (const auto& [key, node] : *table_) {
    const std::string_view name = key.str();
    if (std::find(asked_.begin(), asked_.end(), name) != asked_.end()) continue;
    const std::string place = path_.empty() ? "" : fmt::format(" in {}", path_);
    std::string hint = did_you_mean(name, asked_);
    if (hint.empty()) hint = fmt::format("; there are: {}", join_names(asked_));
    throw Error(fmt::format("there is no {} '{}'{}{}", node.is_table() ? "table" : "key", name,
                            place, hint),
                where(name));
  }
}

}  // namespace polhode
