// SPDX-License-Identifier: MIT
// A table of a TOML file that knows its position, so that every error names file, line and key. It
// records which keys were read; all others are unknown.
#pragma once

#include <toml++/toml.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/settings/quantity.hpp"
#include "polhode/io/settings/overlay.hpp"

namespace polhode {

/// @throws Error  with file and line if the text is not TOML
toml::table parse_toml(std::string_view text, const std::string& file);

/// Replaces and adds the settings of an overlay. "none" for a thermostat or barostat, and 0 steps
/// of hybrid Monte Carlo, remove the table; another type removes the parameters that it does not
/// have; a pressure selects a barostat and a thermostat where there are none; a step removes a
/// required accuracy, a box the density, and each the other way round.
/// @return  notes on what was selected by default
/// @throws Error  if overrides contradict each other, or a parameter has no thermostat
std::vector<std::string> apply(const Overlay& overlay, toml::table& document);

class TomlTable {
 public:
  /// @param overlay  that was applied to the document, for the places of errors; null: none
  TomlTable(const toml::table& table, std::string file, std::string path = {},
            const Overlay* overlay = nullptr)
      : table_(&table), file_(std::move(file)), path_(std::move(path)), overlay_(overlay) {}

  /// The names of all keys.
  std::vector<std::string> keys() const;
  bool has(std::string_view key) { return find(key) != nullptr; }

  // The value of a key, if it exists.
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

  /// The value of a key as written, "\"1 nm\""; empty if the table has no such key.
  std::string written(std::string_view key) const;

  /// "water.toml:9, forces.cutoff", or the option of the overlay, "--cutoff"; the table's own place
  /// if it has no such key.
  std::string where(std::string_view key) const;

  /// Throws `key = value complaint`, or without a key only the complaint.
  [[noreturn]] void refuse(std::string_view key, const std::string& complaint) const;

  /// Throws unless `good` is true: `step = "-2 fs" must be ...`.
  void require(bool good, std::string_view key, const std::string& must) const {
    if (!good) refuse(key, must);
  }

  /// Throws if the table has the old name of a key.
  void renamed(std::string_view old, std::string_view now) const;

  /// Throws if the table has a key that was never read.
  void refuse_unknown() const;

 private:
  const toml::node* find(std::string_view key);
  [[noreturn]] void refuse_kind(std::string_view key, std::string_view must) const;
  std::string text_of(const toml::node& node, std::string_view key) const;
  std::string full(std::string_view key) const;
  /// The override that a key, or the table, has its value or a part of it from; null: none.
  const Override* override_of(std::string_view key) const;

  const toml::table* table_;
  std::string file_, path_;
  std::vector<std::string> asked_;
  const Overlay* overlay_;
};

}  // namespace polhode
