// SPDX-License-Identifier: MIT
// Makes lists of quantities, and shows them as rows of text, CSV files and tables of the manual.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "polhode/io/files/table_file.hpp"
#include "polhode/run/quantities.hpp"

namespace polhode {

/// Marks a quantity as a detail, which a text may omit.
Quantity detail(Quantity quantity);

/// A row that is shown in the text but not in JSON; a row without a label is a line by itself.
Quantity row(std::string label, std::string text);

/// A row with the names of the files that were written; empty if there are none.
Quantity row_of_files(const std::vector<std::string>& files);

/// Quantities that are omitted from the text, because other rows of the text show their numbers.
Quantities without_labels(Quantities list);

/// An estimate from independent runs, which is an object with value and error in JSON; not known if
/// the value is not finite.
SeriesEstimate nested(const Estimate& estimate);
std::optional<SeriesEstimate> nested(const std::optional<Estimate>& estimate);

/// A group of quantities for each element of a list.
template <class List, class Of>
std::vector<Quantities> groups_of(const List& list, const Of& of) {
  std::vector<Quantities> groups;
  for (const auto& element : list) groups.push_back(of(element));
  return groups;
}

/// Adds quantities to a list.
void append(Quantities& list, Quantities more);

/// Replaces each estimate by two numbers, such as "potential_kJ_per_mol" and
/// "potential_error_kJ_per_mol", and "errors_not_known" with the reasons.
Quantities flattened(const Quantities& list);

/// A missing value as text, such as "not known: run too short".
std::string not_known(Known known);

/// A missing error as text, such as ", error not known: run too short"; empty if the error is
/// known.
std::string missing_error(Known known);

/// The text form of a quantity: a row, a title, or a title with a table.
struct TextRow {
  std::string label, text{}, doc{};
  std::size_t level = 0;                          ///< level of indentation
  std::vector<std::vector<std::string>> table{};  ///< head and rows of the table
  std::vector<bool> left{};                       ///< for each column of the table, whether it
                                                  ///< contains texts
};

/// The quantities with labels, and the lines without labels. Details are first.
std::vector<TextRow> text_rows(const Quantities& list);

/// Records in CSV format; an estimate has two columns, such as "R" and "R_error".
Table table_of(const std::vector<Quantities>& records);

/// A Markdown table of all keys with their units and meanings.
std::string documentation(const Quantities& list);

/// JSON of a list. The key "rows" contains the rows of the text as objects with "label", "text",
/// "meaning", "level" and "table". The first row of "table" is the table head.
std::string json_text(const Quantities& list, const std::vector<TextRow>& rows);

}  // namespace polhode
