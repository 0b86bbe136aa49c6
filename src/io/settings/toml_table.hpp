// SPDX-License-Identifier: MIT
// A table of a TOML file that knows its position, so that every error names file, line and key. The
// table records which keys are read; all other keys are reported as unknown.
#pragma once

#include <toml++/toml.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/settings/quantity.hpp"
#include "polhode/base/error.hpp"
#include "polhode/io/settings/overlay.hpp"

namespace polhode {

/// Parses a TOML document.
/// @throws Error  with file and line, if the text is not valid TOML
toml::table parse_toml(std::string_view text, const std::string& file);

/// Replaces and adds the settings of an overlay.
/// - The type "none" of a thermostat or barostat, and 0 steps of hybrid Monte Carlo, remove the
///   table.
/// - Another type removes the parameters that this type does not have.
/// - A pressure selects a barostat and a thermostat if there are none.
/// - An overlay with a step removes a required accuracy, and vice versa. An overlay with a box
///   removes the density, and vice versa.
/// @return  notes on settings that were selected by default
/// @throws Error  if overrides contradict each other, or a thermostat parameter is set without a
///   thermostat
std::vector<std::string> apply(const Overlay& overlay, toml::table& document);

class TomlTable {
 public:
  /// @param overlay  overlay that was applied to the document, for the places in error messages;
  ///   may be null
  TomlTable(const toml::table& table, std::string file, std::string path = {},
            const Overlay* overlay = nullptr)
      : table_(&table), file_(std::move(file)), path_(std::move(path)), overlay_(overlay) {}

  /// The names of all keys in the table.
  std::vector<std::string> keys() const;
  bool has(std::string_view key) { return find(key) != nullptr; }

  // The following functions return the value of a key; empty if the table does not have the key.
  std::optional<std::string> text(std::string_view key);
  std::optional<double> quantity(std::string_view key, Dimension dimension,
                                 std::string_view example = {});
  std::optional<Vec3<double>> vector(std::string_view key, Dimension dimension);
  std::optional<double> number(std::string_view key);
  std::optional<std::int64_t> integer(std::string_view key);
  std::optional<bool> boolean(std::string_view key);
  std::optional<std::vector<std::string>> texts(std::string_view key);
  std::optional<TomlTable> table(std::string_view key);
  std::optional<std::vector<TomlTable>> tables(std::string_view key);
  bool holds_list(std::string_view key);
  bool holds_text(std::string_view key);

  /// The value of a key as written, such as "\"1 nm\""; empty if the table does not have the key.
  std::string written(std::string_view key) const;

  /// The place of a key, such as "water.toml:9, forces.cutoff", or the option of the overlay, such
  /// as "--cutoff". If the table does not have the key, the result is the place of the table.
  std::string where(std::string_view key) const;

  /// Calls action(). An Error that it throws gets the place of a key.
  template <class Action>
  decltype(auto) at(std::string_view key, const Action& action) const {
    return at_place(where(key), action);
  }
  /// Throws an Error of the form `key = value complaint`. Without a key, the error text is only the
  /// complaint.
  [[noreturn]] void refuse(std::string_view key, const std::string& complaint) const;

  /// Throws an Error such as `step = "-2 fs" must be ...` unless `good` is true.
  void require(bool good, std::string_view key, const std::string& must) const {
    if (!good) refuse(key, must);
  }

  /// Throws an Error if the table has the old name of a key.
  void renamed(std::string_view old, std::string_view now) const;

  /// Throws an Error if the table has a key that was never read.
  void refuse_unknown() const;

 private:
  const toml::node* find(std::string_view key);
  [[noreturn]] void refuse_kind(std::string_view key, std::string_view must) const;
  std::string text_of(const toml::node& node, std::string_view key) const;
  std::string full(std::string_view key) const;
  /// The command-line override that set a key, a part of the key's value, or the table; null if
  /// there is none.
  const Override* override_of(std::string_view key) const;

  const toml::table* table_;
  std::string file_, path_;
  std::vector<std::string> asked_;
  const Overlay* overlay_;
};

}  // namespace polhode
