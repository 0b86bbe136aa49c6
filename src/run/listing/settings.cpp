// SPDX-License-Identifier: MIT
#include "run/listing/lists.hpp"

#include <fmt/core.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "io/settings/settings.hpp"

namespace polhode {
namespace {

std::vector<const Setting*> found(const std::string& name) {
  std::vector<const Setting*> all;
  for (const Setting& one : settings())
    if (name.empty() || one.table == name) all.push_back(&one);
  if (all.empty()) all.push_back(&setting(name));
  return all;
}

/// The place of a setting in the run file; empty if the run file does not contain the setting.
std::string place_of(const Setting& one, const Config& config) {
  return config.gives(one.path()) ? config.place(one.path()) : "";
}

/// A bound as a number; null if there is none.
nlohmann::json bound(double value) {
  return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json();
}

std::string lines_of(const Setting& one, const Config* config) {
  std::string text = fmt::format("{}\n", one.path());
  const auto add = [&](const char* label, const std::string& words) {
    if (!words.empty()) text += fmt::format("  {:<8} {}\n", label, words);
  };
  add("meaning", plain_text(one.doc));
  add("values", plain_text(one.domain));
  add("default", plain_text(one.fallback));
  if (!config) return text;
  const std::string value = value_text(one, *config), place = place_of(one, *config);
  if (!value.empty()) add("value", value + (place.empty() ? "" : fmt::format("   ({})", place)));
  return text;
}

}  // namespace

std::string settings_text(const std::string& name, const Config* config) {
  std::string text;
  for (const Setting* one : found(name))
    text += (text.empty() ? "" : "\n") + lines_of(*one, config);
  return text;
}

std::string settings_json(const std::string& name, const Config* config) {
  nlohmann::json all = nlohmann::json::array();
  for (const Setting* one : found(name)) {
    nlohmann::json kinds = nlohmann::json::array();
    for (const SettingKind kind : one->kinds) kinds.push_back(name_of(kind));
    nlohmann::json entry{{"table", one->table},
                         {"key", one->key},
                         {"kinds", kinds},
                         {"unit", one->unit},
                         {"values", plain_text(one->domain)},
                         {"default", plain_text(one->fallback)},
                         {"meaning", plain_text(one->doc)},
                         {"min", bound(one->bounds.min)},
                         {"min_excluded", one->bounds.above},
                         {"max", bound(one->bounds.max)},
                         {"max_excluded", one->bounds.below}};
    if (!one->by.empty()) entry["only_with"] = {{"key", one->by}, {"values", one->by_names}};
    if (config) {
      entry["value"] = value_text(*one, *config);
      entry["place"] = place_of(*one, *config);
    }
    all.push_back(std::move(entry));
  }
  return all.dump(2);
}

}  // namespace polhode
