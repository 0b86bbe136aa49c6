// SPDX-License-Identifier: MIT
// The results of a job as a list of quantities. Loops over this list produce the printed text, the
// JSON, the CSV file and the table in the manual (src/run/quantity_lists.hpp).
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "polhode/math/fit.hpp"
#include "polhode/measure/correlated_series.hpp"

namespace polhode {

struct Quantity;
using Quantities = std::vector<Quantity>;
/// Estimates for the three principal axes.
using AxisEstimates = std::array<SeriesEstimate, 3>;

using AnyValue =
    std::variant<std::monostate, bool, std::int64_t, double, std::string, std::vector<double>,
                 std::vector<std::int64_t>, std::vector<std::vector<double>>,
                 std::vector<std::string>, Estimate, SeriesEstimate, AxisEstimates,
                 std::vector<std::optional<SeriesEstimate>>, Quantities, std::vector<Quantities>>;

/// The value of a quantity: a number, a text, an estimate, a group of quantities, or a list of
/// groups. In printed text, a labelled quantity becomes a row. A labelled group becomes a title
/// with rows, and a labelled list a title with a table. The table has a column for each labelled
/// quantity.
struct Value : AnyValue {
  Value();  ///< Makes the null value.
  Value(bool yes);
  Value(std::int64_t count);
  Value(std::integral auto count) : Value(static_cast<std::int64_t>(count)) {}
  Value(double number);
  Value(const char* text);
  Value(std::string text);
  Value(std::vector<double> numbers);
  Value(std::vector<std::int64_t> counts);
  template <std::integral T>
  Value(const std::vector<T>& counts)
      : Value(std::vector<std::int64_t>(counts.begin(), counts.end())) {}
  Value(std::vector<std::vector<double>> matrix);
  Value(std::vector<std::string> texts);
  Value(const Estimate& estimate);  ///< estimate, two numbers in JSON: "R" and "R_error"
  Value(const SeriesEstimate& estimate);
  Value(const AxisEstimates& estimates);
  Value(std::vector<std::optional<SeriesEstimate>> estimates);
  Value(Quantities group);
  Value(std::vector<Quantities> list);
  template <class T>
  Value(const std::optional<T>& known) : Value(known ? Value(*known) : Value()) {}
  Value(const Value&);
  Value(Value&&) noexcept;
  Value& operator=(const Value&);
  Value& operator=(Value&&) noexcept;
  ~Value();
};

/// A result, with all data that are needed for its output as text and as JSON.
struct Quantity {
  std::string key;  ///< key in JSON without its unit, such as "potential"; empty: only in the text
  /// Unit such as "kJ/mol"; empty if dimensionless; "[kJ/mol]" if the key omits the unit; "%" for a
  /// fraction that the text gives in percent.
  std::string unit;
  /// The value in this unit; null or not finite if it is not known. The rows of a group are
  /// indented below its label in the text, and the group is an object in JSON.
  Value value;
  std::string doc = {};    ///< meaning of the key, for the manual
  std::string label = {};  ///< label of the row in the text; without a label, there is no row,
                           ///< except for the members of a group
  std::string note = {};   ///< note after the value in the text
  /// Column name in a CSV file. If the name is empty, the key is used, but a member of a group then
  /// has no column. "-" means no column.
  std::string column = {};
  int digits = 4;  ///< digits of a number in the text
  /// Details come before all other rows, so that the text ends with the requested results.
  bool detail = false;
};

/// A value with its error, such as "1.20 ± 0.03 ps". If the error is not known, the value has four
/// digits.
std::string text_of(const SeriesEstimate& estimate, std::string_view unit = "");

/// Rows of a list as lines of text, with a blank line after the details.
/// @param details  whether to include the details
std::string text_of(const Quantities& list, bool details = true);

/// A JSON object with units in its keys, as in "length_ps". An estimate is an object with "value"
/// and "error", or with "error_not_known".
std::string json_text(const Quantities& list);
/// Several lists as a JSON array.
std::string json_text(const std::vector<Quantities>& lists);

}  // namespace polhode
