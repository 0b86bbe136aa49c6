// SPDX-License-Identifier: MIT
#include <sstream>

#include "io/settings/config_parts.hpp"
#include "io/settings/scheme_labels.hpp"
#include "list_tables.hpp"
#include "polhode/base/error.hpp"
#include "polhode/io/settings/nested_scheme_text.hpp"

namespace polhode {

OwnSchemes read_schemes(TomlTable table) {
  OwnSchemes own;
  for (const std::string& name : table.keys()) {
    const std::string text = name + ": " + *table.text(name);
    table.at(name, [&] { single_scheme_of(text); });
    own.emplace(name, text);
  }
  return own;
}

std::string with_own_schemes(const std::string& text, const OwnSchemes& own) {
  const bool definitions = text.find(';') != std::string::npos;  // definitions may contain slashes
  if (own.empty() || definitions) return text;
  std::istringstream words(text);
  std::string result, before = "/";
  for (std::string word; words >> word; before = word) {
    const auto scheme = before == "/" ? own.find(word) : own.end();
    result += (result.empty() ? "" : " ") + (scheme == own.end() ? word : scheme->second);
  }
  return result;
}

}  // namespace polhode
