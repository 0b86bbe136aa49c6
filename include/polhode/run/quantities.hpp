// SPDX-License-Identifier: MIT
// The results of a job as a list of quantities: its text, its JSON and its table in the manual are
// loops over the list.
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "polhode/measure/correlated_series.hpp"

namespace polhode {

struct Quantity;
using Quantities = std::vector<Quantity>;
/// One estimate for each principal axis.
using AxisEstimates = std::array<SeriesEstimate, 3>;

using AnyValue =
    std::variant<std::monostate, bool, std::int64_t, double, std::string, std::vector<double>,
                 std::vector<std::string>, SeriesEstimate, AxisEstimates,
                 std::vector<std::optional<SeriesEstimate>>, Quantities, std::vector<Quantities>>;

/// What a quantity is: a number, a text, an estimate, a group of quantities, or a list of them.
struct Value : AnyValue {
  Value();  ///< null
  Value(bool yes);
  Value(std::int64_t count);
  Value(std::integral auto count) : Value(static_cast<std::int64_t>(count)) {}
  Value(double number);
  Value(const char* text);
  Value(std::string text);
  Value(std::vector<double> numbers);
  Value(std::vector<std::string> texts);
  Value(const SeriesEstimate& estimate);
  Value(const AxisEstimates& estimates);
  Value(std::vector<std::optional<SeriesEstimate>> estimates);
  Value(Quantities group);
  Value(std::vector<Quantities> list);
  Value(const Value&);
  Value(Value&&) noexcept;
  Value& operator=(const Value&);
  Value& operator=(Value&&) noexcept;
  ~Value();
};

/// One result with all that is needed to show it.
struct Quantity {
  std::string key;  ///< in JSON, where the unit follows: "potential"; empty: only a row of the text
  std::string unit;  ///< "kJ/mol"; "" without one; "%": a fraction, in percent in the text
  /// In that unit; not finite, or null, if it is not known. A group is an object of JSON, and its
  /// rows are indented below its label.
  Value value;
  std::string doc = {};    ///< meaning of the key, for the manual
  std::string label = {};  ///< of a row of the text; empty: no row, but the rows of a group
  std::string note = {};   ///< follows the value in the text
};

/// A row of the text that is not in JSON.
Quantity row(std::string label, std::string text);

/// Adds quantities to a list.
void append(Quantities& list, Quantities more);

/// The same quantities with each estimate as two numbers, "potential_kJ_per_mol" and
/// "potential_error_kJ_per_mol", and "errors_not_known" with the reasons.
Quantities flattened(const Quantities& list);

/// "not known: run too short".
std::string not_known(Known known);

/// ", error not known: run too short"; empty if it is known.
std::string missing_error(Known known);

/// A value with its error, "1.20 ± 0.03 ps"; with four digits if that is not known.
std::string text_of(const SeriesEstimate& estimate, std::string_view unit = "");

/// The rows with labels, each a line.
std::string text_of(const Quantities& list);

/// Keys with units, as in "length_ps"; an estimate is an object with "value", "error", and
/// "error_not_known" where it is not.
std::string json_text(const Quantities& list);

/// A table of Markdown with the keys, their units and meanings.
std::string documentation(const Quantities& list);

}  // namespace polhode
