// SPDX-License-Identifier: MIT
#include "temperature_differences.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string>

#include "io/files/with_error.hpp"
#include "io/settings/output_units.hpp"
#include "run/quantity_lists.hpp"

namespace polhode {
namespace {

std::vector<std::optional<SeriesEstimate>> list_of(const auto& estimates) {
  std::vector<std::optional<SeriesEstimate>> list;
  for (const std::optional<Estimate>& e : estimates)
    list.push_back(e ? std::optional(nested(*e)) : std::nullopt);
  return list;
}

Quantities of_limit(const EquipartitionFit& fit, Value axis, const Line& line) {
  return {{"scheme", "", fit.scheme, "name of the scheme"},
          {"axis", "", std::move(axis), "principal axis; null for translation"},
          {"order", "", fit.order, "order k of the fitted function a + b h^k of the time step h"},
          {"without_step", "K", line.intercept,
           "fitted temperature difference a at time step 0; `without_step_error` is its standard "
           "error [K]"},
          {"slope", "K/ps to the order", line.slope,
           "fitted coefficient b of h^k; `slope_error` is its standard error"},
          {"degrees_of_freedom", "", line.degrees_of_freedom,
           "number of degrees of freedom of the standard errors"},
          {"without_step_p_value", "", p_value(line.intercept, line.degrees_of_freedom),
           "probability that chance alone gives a fitted a of at least this size"}};
}

/// The fitted limit for zero step, with a p-value if the limit differs significantly from 0.
Value limit_value(const std::optional<Line>& line) {
  if (!line) return {};
  const double p = p_value(line->intercept, line->degrees_of_freedom);
  return with_error(line->intercept.value, line->intercept.error) +
         (p < significance ? fmt::format(" (p {:.1g})", p) : "");
}

/// Makes a table of temperature differences.
/// @param columns  the kinds of temperature differences
/// @param at       function that returns the differences at a point
/// @param limits   fitted lines
Quantities table(const std::vector<Curve>& curves, const std::vector<EquipartitionFit>& fits,
                 const char* title, const std::vector<const char*>& columns, const auto& at,
                 const auto& limits) {
  bool known = false;
  std::vector<Quantities> rows;
  const auto add = [&](const std::string& scheme, Value step, const auto& value) {
    Quantities row = {{"", "", scheme, "", "scheme"}, {"", "fs", std::move(step), "", "step"}};
    for (std::size_t k = 0; k < columns.size(); ++k)
      row.push_back({"", "K", value(k), "", columns[k]});
    rows.push_back(std::move(row));
  };
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const auto& points = curves[c].points;
    for (const EfficiencyPoint& p : points)
      known = known || std::any_of(at(p).begin(), at(p).end(), [](auto& e) { return !!e; });
    for (std::size_t i = 0; i < curves[c].usable; ++i)
      add(points[i].scheme, points[i].step * units::fs_per_ps,
          [&](std::size_t k) { return Value(at(points[i])[k]); });
    add("", fmt::format("0, k = {}", fits[c].order),
        [&](std::size_t k) { return limit_value(limits(fits[c])[k]); });
  }
  if (!known) return {};
  return {{"", "", rows, "", fmt::format("{}, and extrapolated to h = 0 by a + b h^k", title)}};
}

}  // namespace

Quantities excesses(const EfficiencyPoint& point) {
  return {
      {"excess", "K", list_of(point.excess),
       "temperature of rotation about each principal axis minus the temperature of translation"},
      {"configurational_excess", "K", list_of(point.configurational_excess),
       "configurational minus kinetic temperature of translation, and of rotation about each "
       "principal axis"}};
}

Quantities limits(const std::vector<EquipartitionFit>& fits) {
  std::vector<Quantities> kinetic, configurational;
  for (const EquipartitionFit& fit : fits) {
    for (std::size_t k = 0; k < fit.axes.size(); ++k)
      if (fit.axes[k]) kinetic.push_back(of_limit(fit, k + 1, *fit.axes[k]));
    for (std::size_t k = 0; k < fit.configurational.size(); ++k)
      if (fit.configurational[k])
        configurational.push_back(
            of_limit(fit, k == 0 ? Value() : Value(k), *fit.configurational[k]));
  }
  return {
      {kinetic.empty() ? "" : "equipartition", "", kinetic, "`excess_K` extrapolated to zero step"},
      {configurational.empty() ? "" : "configurational", "", configurational,
       "`configurational_excess_K` extrapolated to zero step"}};
}

Quantities temperature_tables(const std::vector<Curve>& curves,
                              const std::vector<EquipartitionFit>& fits) {
  Quantities tables = table(
      curves, fits,
      "temperature of rotation about each principal axis minus the temperature of translation",
      {"axis 1", "axis 2", "axis 3"},
      [](const EfficiencyPoint& p) -> const auto& { return p.excess; },
      [](const EquipartitionFit& fit) -> const auto& { return fit.axes; });
  append(
      tables,
      table(
          curves, fits, "configurational minus kinetic temperature of translation and of rotation",
          {"translation", "axis 1", "axis 2", "axis 3"},
          [](const EfficiencyPoint& p) -> const auto& { return p.configurational_excess; },
          [](const EquipartitionFit& fit) -> const auto& { return fit.configurational; }));
  return tables;
}

}  // namespace polhode
