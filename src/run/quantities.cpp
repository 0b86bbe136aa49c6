// SPDX-License-Identifier: MIT
#include "polhode/run/quantities.hpp"

#include <fmt/core.h>

#include <cmath>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "io/files/with_error.hpp"

namespace polhode {
namespace {

using nlohmann::json;

/// "_kJ_per_mol_ps" of "kJ/mol/ps", and "_per_bar" of "1/bar".
std::string suffix(const std::string& unit) {
  if (unit.empty() || unit == "%") return "";
  std::string text = "_";
  for (const char c : unit.starts_with("1/") ? unit.substr(1) : unit)
    if (c == '/' && text.find("per_") == text.npos)
      text += text == "_" ? "per_" : "_per_";
    else if (c != ')')
      text += c == '/' || c == ' ' || c == '(' ? '_' : c;
  return text;
}

std::string full_key(const Quantity& q) { return q.key + suffix(q.unit); }

/// Not a number where it is not known.
double known_error(const SeriesEstimate& e) {
  return e.known == Known::yes ? e.error : std::numeric_limits<double>::quiet_NaN();
}

/// Numbers that are not finite are null in the text of JSON.
struct AsJson {
  json operator()(std::monostate) const { return {}; }
  json operator()(const auto& value) const { return value; }
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
    for (const Quantity& q : group)
      if (!q.key.empty())
        one[full_key(q)] = std::visit(*this, static_cast<const AnyValue&>(q.value));
    return one;
  }

 private:
  json list_of(const auto& list) const {
    json all = json::array();
    for (const auto& one : list) all.push_back((*this)(one));
    return all;
  }
};

/// A text as it is, a number with four digits.
struct AsText {
  double scale;
  std::string operator()(const auto&) const { return ""; }
  std::string operator()(bool yes) const { return yes ? "yes" : "no"; }
  std::string operator()(std::int64_t count) const { return fmt::format("{}", count); }
  std::string operator()(double x) const { return fmt::format("{:.4g}", scale * x); }
  std::string operator()(const std::string& text) const { return text; }
  std::string operator()(const SeriesEstimate& e) const { return text_of(scaled(e, scale)); }
};

/// The value, its unit, the note, and why there is no error.
std::string value_text(const Quantity& q) {
  const auto* e = std::get_if<SeriesEstimate>(&q.value);
  if (e && !std::isfinite(e->value)) return not_known(e->known) + q.note;
  return std::visit(AsText{q.unit == "%" ? 100.0 : 1.0}, static_cast<const AnyValue&>(q.value)) +
         (q.unit.empty() ? "" : " ") + q.unit + q.note + (e ? missing_error(e->known) : "");
}

std::string rows(const Quantities& list, const std::string& indent) {
  std::string text;
  for (const Quantity& q : list)
    if (const auto* group = std::get_if<Quantities>(&q.value)) {
      if (!q.label.empty()) text += indent + q.label + "\n";
      text += rows(*group, q.label.empty() ? indent : indent + "  ");
    } else if (const auto* list_of_groups = std::get_if<std::vector<Quantities>>(&q.value)) {
      for (const Quantities& one : *list_of_groups) text += rows(one, indent);
    } else if (!q.label.empty()) {
      text += fmt::format("{:<22}{}\n", indent + q.label, value_text(q));
    }
  return text;
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
  }
  return table;
}

}  // namespace

// Here, where the quantities of a group are complete.
Value::Value() = default;
Value::Value(bool yes) : AnyValue(yes) {}
Value::Value(std::int64_t count) : AnyValue(count) {}
Value::Value(double number) : AnyValue(number) {}
Value::Value(const char* text) : AnyValue(std::string(text)) {}
Value::Value(std::string text) : AnyValue(std::move(text)) {}
Value::Value(std::vector<double> numbers) : AnyValue(std::move(numbers)) {}
Value::Value(std::vector<std::string> texts) : AnyValue(std::move(texts)) {}
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

Quantity row(std::string label, std::string text) {
  return {"", "", std::move(text), "", std::move(label)};
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

std::string text_of(const Quantities& list) { return rows(list, ""); }

std::string json_text(const Quantities& list) { return AsJson()(list).dump(2); }

std::string documentation(const Quantities& list) {
  return "| key | unit | meaning |\n| --- | --- | --- |\n" + documented(list, "");
}

}  // namespace polhode
