// SPDX-License-Identifier: MIT
#include "polhode/io/settings/overlay.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <sstream>

#include "io/settings/config_parts.hpp"
#include "polhode/base/error.hpp"
#include "setting_rows.hpp"
#include "toml_table.hpp"

namespace polhode {
namespace {

/// Pairs of alternative settings. An overlay that sets one key of a pair removes the other key.
constexpr std::array<std::array<std::string_view, 2>, 7> replacements{
    {{"integrator.step", "integrator.accuracy"},
     {"integrator.accuracy", "integrator.step"},
     {"system.density", "system.box"},
     {"system.box", "system.density"},
     {"system.molecules", "system.topology"},
     {"system.molecules", "system.initial_configuration"},
     {"thermostat.friction", "thermostat.rotational_friction"}}};

// Paths have the form "table.key" or "table".

const toml::node* node_at(const toml::table& document, std::string_view path) {
  const auto dot = path.find('.');
  const toml::node* const found = document.get(path.substr(0, dot));
  if (found == nullptr || dot == path.npos) return found;
  return found->is_table() ? found->as_table()->get(path.substr(dot + 1)) : nullptr;
}

/// Stores a copy of a value at a path in a document. Unlike a parsed value, the copy has no
/// position in a file.
template <class Value>
void set(toml::table& document, std::string_view path, const Value& value) {
  const auto dot = path.find('.');
  if (dot == path.npos) return void(document.insert_or_assign(path, value));
  toml::node& table =
      document.insert(path.substr(0, dot), toml::table{}).first->second;  // unless the table exists
  if (table.is_table()) table.as_table()->insert_or_assign(path.substr(dot + 1), value);
}

void set(toml::table& document, const Override& one) {
  if (!one.toml.empty()) {
    const toml::table parsed = parse_toml("value = " + one.toml, one.place);
    parsed.get("value")->visit([&](const auto& value) { set(document, one.key, value); });
  } else if (one.values.size() == 1) {
    set(document, one.key, one.values.front());
  } else {
    toml::array list;
    for (const std::string& value : one.values) list.push_back(value);
    set(document, one.key, list);
  }
}

void remove(toml::table& document, std::string_view path) {
  const auto dot = path.find('.');
  if (dot == path.npos)
    document.erase(path);
  else if (toml::table* const table = document[path.substr(0, dot)].as_table())
    table->erase(path.substr(dot + 1));
}

/// The changes that an overlay requires in addition to its own settings.
class Effects {
 public:
  Effects(const Overlay& overlay, toml::table& document) : overlay_(overlay), document_(document) {}

  /// Applies the overlay and its additional changes; returns notes.
  std::vector<std::string> apply() {
    for (const auto& [one, other] : replacements)
      if (given(one) != nullptr && given(other) == nullptr) remove(document_, other);
    set_type("thermostat");
    set_type("barostat");
    if (value_is("hybrid_monte_carlo.steps", "0")) removed_.emplace_back("hybrid_monte_carlo");
    check_thermostat();
    select_for_pressure();
    for (const Override& one : overlay_.settings) set(document_, one);
    for (const std::string_view table : removed_) remove(document_, table);
    return std::move(notes_);
  }

 private:
  const Override* given(std::string_view key) const { return overlay_.find(key); }
  const Override* given(std::string_view table, std::string_view key) const {
    return given(fmt::format("{}.{}", table, key));
  }
  bool present(std::string_view path) const { return node_at(document_, path) != nullptr; }
  bool value_is(std::string_view key, std::string_view value) const {
    const Override* const one = given(key);
    if (one == nullptr) return false;
    return one->toml.empty() ? one->values.front() == value
                             : one->toml == value || one->toml == fmt::format("\"{}\"", value);
  }

  /// Sets the type of a table. A new type removes those parameters of the table that the type does
  /// not have. The type "none" removes the table.
  void set_type(std::string_view table) {
    const std::string key = fmt::format("{}.type", table);
    const Override* const type = given(key);
    if (type == nullptr) return;
    if (value_is(key, "none")) {
      if (const Override* const pressure = given("barostat.pressure");
          pressure != nullptr && table == "barostat")
        throw Error(fmt::format("{} contradicts {} none; give only one of the two", pressure->place,
                                type->place));
      removed_.push_back(table);
    }
    for (const SettingRow& row : setting_table(table).rows) {
      const auto types = deciding_names(row);
      if (!types.empty() && given(table, row.key) == nullptr &&
          std::none_of(types.begin(), types.end(),
                       [&](const std::string& one) { return value_is(key, one); }))
        remove(document_, fmt::format("{}.{}", table, row.key));
    }
  }

  void check_thermostat() const {
    if (present("thermostat") || given("thermostat.type") != nullptr) return;
    for (const SettingRow& row : setting_table("thermostat").rows)
      if (const Override* const one = given(row.table, row.key))
        throw Error(fmt::format("{} is a setting of a thermostat, but this run has no thermostat; "
                                "also select the thermostat {}",
                                row.key, deciding_names(row).front()),
                    one->place);
  }

  void select_for_pressure() {
    const Override* const pressure = given("barostat.pressure");
    if (pressure == nullptr) return;
    if (!present("barostat") && given("barostat.type") == nullptr)
      notes_.push_back(
          fmt::format("note: {} without a barostat selects cell-rescaling", pressure->place));
    const bool hybrid = given("hybrid_monte_carlo.steps") != nullptr
                            ? !value_is("hybrid_monte_carlo.steps", "0")
                            : present("hybrid_monte_carlo");
    if (!overlay_.pressure_selects_thermostat || hybrid || present("thermostat") ||
        given("thermostat.type") != nullptr)
      return;
    set(document_, "thermostat.type", std::string("langevin"));
    notes_.push_back(
        fmt::format("note: {} without a thermostat selects langevin", pressure->place));
  }

  const Overlay& overlay_;
  toml::table& document_;
  std::vector<std::string_view> removed_;  // tables that were removed
  std::vector<std::string> notes_;
};

}  // namespace

const Override* Overlay::find(std::string_view key) const {
  const auto found = std::find_if(settings.rbegin(), settings.rend(),
                                  [&](const Override& o) { return o.key == key; });
  return found == settings.rend() ? nullptr : &*found;
}

std::vector<std::string> apply(const Overlay& overlay, toml::table& document) {
  if (overlay.settings.empty()) return {};
  return Effects(overlay, document).apply();
}

std::string overlaid_text(std::string_view text, const std::string& file, const Overlay& overlay) {
  if (overlay.settings.empty()) return std::string(text);
  toml::table document = parse_toml(text, file);
  apply(overlay, document);
  std::ostringstream written;
  written << document << '\n';
  return written.str();
}

}  // namespace polhode
