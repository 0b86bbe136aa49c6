// SPDX-License-Identifier: MIT
#include "polhode/run/quantities.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <span>
#include <utility>

#include "base/printable.hpp"
#include "io/files/with_error.hpp"
#include "run/quantity_lists.hpp"

namespace polhode {
namespace {

using nlohmann::json;

/// The suffix of a name in JSON for a unit: "_kJ_per_mol_ps" for "kJ/mol/ps", and "_per_bar" for
/// "1/bar".
std::string suffix(const std::string& unit) {
  if (unit.empty() || unit == "%" || unit.starts_with('[')) return "";
  std::string text = "_";
  for (const char c : unit.starts_with("1/") ? unit.substr(1) : unit)
    if (c == '/' && text.find("per_") == text.npos)
      text += text == "_" ? "per_" : "_per_";
    else if (c != ')')
      text += c == '/' || c == ' ' || c == '(' ? '_' : c;
  return text;
}

std::string full_key(const Quantity& q) { return q.key + suffix(q.unit); }

/// The text form of a unit.
std::string shown_unit(const Quantity& q) {
  return q.unit.starts_with('[') ? q.unit.substr(1, q.unit.size() - 2) : q.unit;
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr SeriesEstimate not_finite{nan, nan, Known::not_defined};

/// The number of a value; NaN if the value is not a number.
double number_of(const Value& value) {
  if (const auto* x = std::get_if<double>(&value)) return *x;
  if (const auto* count = std::get_if<std::int64_t>(&value)) return static_cast<double>(*count);
  const auto* yes = std::get_if<bool>(&value);
  return yes ? static_cast<double>(*yes) : nan;
}

/// The standard error; NaN if the error is not known.
double known_error(const SeriesEstimate& e) { return e.known == Known::yes ? e.error : nan; }

/// Writes numbers as JSON, where numbers that are not finite are null.
struct AsJson {
  json operator()(std::monostate) const { return {}; }
  json operator()(const auto& value) const { return value; }
  json operator()(const Estimate& e) const { return e.value; }
  json operator()(const SeriesEstimate& e) const {
    json one{{"value", e.value}, {"error", known_error(e)}};
    if (e.known != Known::yes) one["error_not_known"] = reason(e.known);
    return one;
  }
  json operator()(const std::optional<SeriesEstimate>& e) const { return e ? (*this)(*e) : json(); }
  json operator()(const AxisEstimates& list) const { return list_of(list); }
  json operator()(const std::vector<std::optional<SeriesEstimate>>& list) const {
    return list_of(list);
  }
  json operator()(const std::vector<Quantities>& list) const { return list_of(list); }
  json operator()(const Quantities& group) const {
    json one = json::object();
    for (const Quantity& q : group) {
      if (q.key.empty()) continue;
      one[full_key(q)] = std::visit(*this, static_cast<const AnyValue&>(q.value));
      if (const auto* e = std::get_if<Estimate>(&q.value)) one[q.key + "_error"] = e->error;
    }
    return one;
  }

 private:
  json list_of(const auto& list) const {
    json all = json::array();
    for (const auto& one : list) all.push_back((*this)(one));
    return all;
  }
};

/// Writes values as text: texts unchanged, and numbers with a few digits. The text is empty if the
/// value is not known.
struct AsText {
  double scale;
  int digits;
  std::string operator()(const auto&) const { return ""; }
  std::string operator()(bool yes) const { return yes ? "yes" : "no"; }
  std::string operator()(std::int64_t count) const { return fmt::format("{}", count); }
  std::string operator()(double x) const {
    return std::isfinite(x) ? fmt::format("{:.{}g}", scale * x, digits) : "";
  }
  std::string operator()(const std::string& text) const { return text; }
  std::string operator()(const std::vector<double>& numbers) const {
    std::string text;
    for (const double x : numbers) text += (text.empty() ? "" : "  ") + (*this)(x);
    return text;
  }
  std::string operator()(const Estimate& e) const { return (*this)(nested(e)); }
  std::string operator()(const SeriesEstimate& e) const {
    return std::isfinite(e.value) ? text_of(scaled(e, scale)) : "";
  }
};

std::string number_text(const Quantity& q) {
  return std::visit(AsText{q.unit == "%" ? 100.0 : 1.0, q.digits},
                    static_cast<const AnyValue&>(q.value));
}

/// A quantity as text: value, unit, note, and the reason why the error is not known, if any.
std::string value_text(const Quantity& q) {
  const auto* e = std::get_if<SeriesEstimate>(&q.value);
  if (e && !std::isfinite(e->value)) return not_known(e->known) + q.note;
  const std::string number = number_text(q);
  if (number.empty() && !std::holds_alternative<std::string>(q.value)) return "-" + q.note;
  return number + (q.unit.empty() ? "" : " ") + shown_unit(q) + q.note +
         (e ? missing_error(e->known) : "");
}

/// Calls visit(quantity) for each quantity of all groups.
void each(const Quantities& list, const auto& visit) {
  for (const Quantity& q : list)
    if (const auto* group = std::get_if<Quantities>(&q.value))
      each(*group, visit);
    else
      visit(q);
}

/// Makes a table of the labelled quantities; all records have the same labels.
TextRow table_row(const Quantity& of, const std::vector<Quantities>& records, std::size_t level) {
  TextRow row{of.label, "", of.doc, level};
  for (const Quantities& record : records) {
    std::vector<std::string> head, cells;
    std::vector<bool> left;
    each(record, [&](const Quantity& q) {
      if (q.label.empty()) return;
      const std::string text = number_text(q);
      head.push_back(q.unit.empty() ? q.label : fmt::format("{} [{}]", q.label, shown_unit(q)));
      left.push_back(std::holds_alternative<std::string>(q.value));
      cells.push_back(text.empty() && !left.back() ? "-" : text + q.note);
    });
    if (row.table.empty()) row.table.push_back(head), row.left = left;
    row.table.push_back(cells);
  }
  return row;
}

/// Whether a quantity is shown as a line of text without a label.
bool is_line(const Quantity& q) {
  return q.key.empty() && q.column.empty() && std::holds_alternative<std::string>(q.value);
}

/// Adds quantities as rows.
/// @param details  whether to add the details, rather than all other quantities
void add_rows(std::vector<TextRow>& rows, const Quantities& list, bool details,
              std::size_t level = 0) {
  for (const Quantity& q : list) {
    if (!q.label.empty() || is_line(q))
      if (level == 0 && q.detail != details) continue;
    const std::size_t below = level + (q.label.empty() ? 0 : 1);
    if (const auto* group = std::get_if<Quantities>(&q.value)) {
      if (!q.label.empty()) rows.push_back({q.label, "", q.doc, level});
      add_rows(rows, *group, details, below);
    } else if (const auto* records = std::get_if<std::vector<Quantities>>(&q.value)) {
      if (!q.label.empty() && !records->empty()) rows.push_back(table_row(q, *records, level));
      if (q.label.empty())
        for (const Quantities& one : *records) add_rows(rows, one, details, level);
    } else if (const auto* texts = std::get_if<std::vector<std::string>>(&q.value)) {
      if (q.label.empty()) continue;
      rows.push_back({q.label, "", q.doc, level});
      for (const std::string& text : *texts) rows.push_back({"", text, "", below});
    } else if (!q.label.empty() || is_line(q)) {
      rows.push_back({q.label, value_text(q), q.doc, level});
    }
  }
}

std::string lines_of(const TextRow& row) {
  std::vector<std::size_t> widths(row.left.size());
  for (const auto& cells : row.table)
    for (std::size_t k = 0; k < cells.size(); ++k)
      widths[k] = std::max(widths[k], character_count(cells[k]));
  std::string text = row.label + "\n";
  for (const auto& cells : row.table) {
    std::string line;
    for (std::size_t k = 0; k < cells.size(); ++k)
      line += row.left[k] ? fmt::format("{:<{}}  ", cells[k], widths[k])
                          : fmt::format("{:>{}}  ", cells[k], widths[k]);
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

constexpr std::size_t label_width = 22;

/// A text next to a label. Further lines of the text are aligned with the first line.
std::string next_to_label(std::string text) {
  const std::string below = "\n" + std::string(label_width, ' ');
  for (auto at = text.find('\n'); at != text.npos; at = text.find('\n', at + 1))
    text.replace(at, 1, below);
  return text;
}

/// Writes rows as lines, with a blank line before and after each table.
std::string lines_of(const std::vector<TextRow>& rows) {
  std::string text;
  bool apart = false;
  for (const TextRow& row : rows) {
    const bool table = !row.table.empty();
    if (!text.empty() && (table || apart)) text += "\n";
    apart = table;
    const std::string indent(2 * row.level, ' ');
    if (table)
      text += lines_of(row);
    else if (row.label.empty() || row.text.empty())
      text += indent + row.label + row.text + "\n";
    else
      text += fmt::format("{:<{}}{}\n", indent + row.label, label_width, next_to_label(row.text));
  }
  return text;
}

/// Adds a record as a row to a table for a CSV file; the first record also defines the columns.
void add_cells(Table& table, const Quantities& record) {
  const bool first = table.rows.empty();
  table.rows.emplace_back();
  const auto add = [&](const std::string& name, const std::string& unit, Cell cell) {
    if (first) table.columns.push_back({name, unit});
    table.rows.back().push_back(std::move(cell));
  };
  const auto add_estimate = [&](const std::string& name, const std::string& unit, double value,
                                double error) {
    add(name, unit, value);
    add(name + "_error", unit, error);
  };
  const auto add_quantity = [&](const Quantity& q, const std::string& name) {
    if (const auto* text = std::get_if<std::string>(&q.value)) return add(name, "", *text);
    const std::string unit = q.unit.empty() || q.unit == "%" ? "1" : shown_unit(q);
    if (const auto* estimate = std::get_if<Estimate>(&q.value))
      return add_estimate(name, unit, estimate->value, estimate->error);
    if (const auto* series = std::get_if<SeriesEstimate>(&q.value))
      return add_estimate(name, unit, series->value, series->error);
    const auto* list = std::get_if<std::vector<std::optional<SeriesEstimate>>>(&q.value);
    if (list == nullptr) return add(name, unit, number_of(q.value));
    // Quantities for each principal axis, preceded by the quantity for translation if there is one.
    for (std::size_t k = 0; k < list->size(); ++k) {
      const std::size_t axis = k + (list->size() == 3 ? 1 : 0);
      const SeriesEstimate one = (*list)[k].value_or(not_finite);
      add_estimate(fmt::format("{}_{}", name, axis == 0 ? "translation" : std::to_string(axis)),
                   unit, one.value, one.error);
    }
  };
  for (const Quantity& q : record)
    if (const auto* group = std::get_if<Quantities>(&q.value))
      each(*group, [&](const Quantity& inner) {
        if (!inner.column.empty()) add_quantity(inner, inner.column);
      });
    else if (const std::string& name = q.column.empty() ? q.key : q.column;
             !name.empty() && name != "-")
      add_quantity(q, name);
}

std::string documented(const Quantities& list, const std::string& prefix) {
  std::string table;
  for (const Quantity& q : list) {
    if (q.key.empty()) continue;
    if (!q.doc.empty())
      table += fmt::format("| `{}{}` | {} | {} |\n", prefix, full_key(q),
                           q.unit == "%" ? "" : q.unit, q.doc);
    if (const auto* group = std::get_if<Quantities>(&q.value))
      table += documented(*group, prefix + q.key + ".");
    else if (const auto* records = std::get_if<std::vector<Quantities>>(&q.value))
      for (const Quantities& first : std::span(*records).first(records->empty() ? 0 : 1))
        table += documented(first, prefix + q.key + "[].");
  }
  return table;
}

}  // namespace

// Members of Value that need the complete type of a group of quantities are defined here.
Value::Value() = default;
Value::Value(bool yes) : AnyValue(yes) {}
Value::Value(std::int64_t count) : AnyValue(count) {}
Value::Value(double number) : AnyValue(number) {}
Value::Value(const char* text) : AnyValue(std::string(text)) {}
Value::Value(std::string text) : AnyValue(std::move(text)) {}
Value::Value(std::vector<double> numbers) : AnyValue(std::move(numbers)) {}
Value::Value(std::vector<std::int64_t> counts) : AnyValue(std::move(counts)) {}
Value::Value(std::vector<std::vector<double>> matrix) : AnyValue(std::move(matrix)) {}
Value::Value(std::vector<std::string> texts) : AnyValue(std::move(texts)) {}
Value::Value(const Estimate& estimate) : AnyValue(estimate) {}
Value::Value(const SeriesEstimate& estimate) : AnyValue(estimate) {}
Value::Value(const AxisEstimates& estimates) : AnyValue(estimates) {}
Value::Value(std::vector<std::optional<SeriesEstimate>> estimates)
    : AnyValue(std::move(estimates)) {}
Value::Value(Quantities group) : AnyValue(std::move(group)) {}
Value::Value(std::vector<Quantities> list) : AnyValue(std::move(list)) {}
Value::Value(const Value&) = default;
Value::Value(Value&&) noexcept = default;
Value& Value::operator=(const Value&) = default;
Value& Value::operator=(Value&&) noexcept = default;
Value::~Value() = default;

Quantity detail(Quantity quantity) {
  quantity.detail = true;
  return quantity;
}

Quantity row(std::string label, std::string text) {
  return {"", "", std::move(text), "", std::move(label)};
}

Quantity row_of_files(const std::vector<std::string>& files) {
  return files.empty() ? Quantity() : row("files", fmt::format("{}", fmt::join(files, " ")));
}

Quantities without_labels(Quantities list) {
  for (Quantity& q : list) {
    q.label.clear();
    if (auto* const group = std::get_if<Quantities>(&q.value)) *group = without_labels(*group);
  }
  return list;
}

SeriesEstimate nested(const Estimate& e) {
  if (!std::isfinite(e.value)) return not_finite;
  return {e.value, e.error, Known::yes};
}

std::optional<SeriesEstimate> nested(const std::optional<Estimate>& e) {
  return e ? std::optional(nested(*e)) : std::nullopt;
}

void append(Quantities& list, Quantities more) {
  std::move(more.begin(), more.end(), std::back_inserter(list));
}

Quantities flattened(const Quantities& list) {
  Quantities flat, reasons;
  for (const Quantity& q : list) {
    const std::string error_key = q.key + "_error";
    const auto note = [&](Known known) {
      if (known != Known::yes) reasons.push_back({error_key + suffix(q.unit), "", reason(known)});
    };
    if (q.key.empty()) continue;
    if (const auto* e = std::get_if<SeriesEstimate>(&q.value)) {
      append(flat, {{q.key, q.unit, e->value}, {error_key, q.unit, known_error(*e)}});
      note(e->known);
    } else if (const auto* axes = std::get_if<AxisEstimates>(&q.value)) {
      std::vector<double> values, errors;
      Known worst = Known::yes;
      for (const SeriesEstimate& axis : *axes) {
        values.push_back(axis.value);
        errors.push_back(known_error(axis));
        if (axis.known != Known::yes) worst = axis.known;
      }
      note(worst);
      append(flat, {{q.key, q.unit, values}, {error_key, q.unit, errors}});
    } else {
      flat.push_back(q);
    }
  }
  flat.push_back({"errors_not_known", "", reasons});
  return flat;
}

std::string not_known(Known known) { return "not known: " + reason(known); }

std::string missing_error(Known known) {
  return known == Known::yes ? "" : ", error " + not_known(known);
}

std::string text_of(const SeriesEstimate& e, std::string_view unit) {
  const std::string number =
      e.known == Known::yes ? with_error(e.value, e.error) : fmt::format("{:.4g}", e.value);
  return fmt::format("{}{}{}", number, unit.empty() ? "" : " ", unit);
}

std::vector<TextRow> text_rows(const Quantities& list) {
  std::vector<TextRow> rows;
  for (const bool details : {true, false}) add_rows(rows, list, details);
  return rows;
}

std::string text_of(const Quantities& list, bool details) {
  std::vector<TextRow> first, last;
  if (details) add_rows(first, list, true);
  add_rows(last, list, false);
  std::string text = lines_of(first);
  if (!text.empty() && !last.empty()) text += "\n";
  return text + lines_of(last);
}

Table table_of(const std::vector<Quantities>& records) {
  Table table;
  for (const Quantities& record : records) add_cells(table, record);
  return table;
}

std::string json_text(const Quantities& list) { return AsJson()(list).dump(2); }

std::string json_text(const std::vector<Quantities>& lists) { return AsJson()(lists).dump(2); }

std::string json_text(const Quantities& list, const std::vector<TextRow>& rows) {
  json all = AsJson()(list);
  for (const TextRow& row : rows)
    all["rows"].push_back({{"label", row.label},
                           {"text", row.text},
                           {"meaning", row.doc},
                           {"level", row.level},
                           {"table", row.table}});
  return all.dump(2);
}

std::string documentation(const Quantities& list) {
  return "| key | unit | meaning |\n| --- | --- | --- |\n" + documented(list, "");
}

}  // namespace polhode
