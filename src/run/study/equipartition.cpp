// SPDX-License-Identifier: MIT
#include "run/study/equipartition.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "io/files/with_error.hpp"
#include "io/settings/output_units.hpp"
#include "run/quantity_lists.hpp"

namespace polhode {
namespace {

/// The temperature differences of a scheme at its usable steps.
struct Points {
  std::vector<double> x;  ///< powers hᵏ of the steps h
  std::vector<Estimate> y;
  double degrees_of_freedom = 0;  ///< degrees of freedom of the errors of the temperature
                                  ///< differences
};

/// The temperature differences of a curve.
/// @param excess  function that returns the temperature difference at a point
Points points_of(const Curve& curve, int order, const auto& excess) {
  Points points;
  std::vector<double> runs;
  double squares = 0;  // sum of squared deviations of single runs
  for (std::size_t i = 0; i < curve.usable; ++i) {
    const std::optional<Estimate> known = excess(curve.points[i]);
    if (!known || !(known->error > 0) || curve.points[i].runs < 2) continue;
    points.x.push_back(std::pow(curve.points[i].step, order));
    points.y.push_back(*known);
    runs.push_back(curve.points[i].runs);
    squares += (runs.back() - 1) * runs.back() * known->error * known->error;
    points.degrees_of_freedom += runs.back() - 1;
  }
  for (std::size_t i = 0; i < runs.size(); ++i)
    points.y[i].error = std::sqrt(squares / points.degrees_of_freedom / runs[i]);
  return points;
}

std::optional<Line> limit(Points points) {
  if (points.degrees_of_freedom < EquipartitionFit::min_free) return std::nullopt;
  for (bool shortened = false; points.x.size() >= (shortened ? 3 : 2); shortened = true) {
    Line line = weighted_line(points.x, points.y);
    line.degrees_of_freedom = points.degrees_of_freedom;
    if (misfit_p_value(line, points.x, points.y) >= significance) return line;
    points.x.pop_back();
    points.y.pop_back();
  }
  return std::nullopt;
}

std::vector<std::optional<SeriesEstimate>> list_of(const auto& estimates) {
  std::vector<std::optional<SeriesEstimate>> list;
  for (const std::optional<Estimate>& e : estimates) list.push_back(nested(e));
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

std::vector<EquipartitionFit> equipartition(const std::vector<Curve>& curves) {
  std::vector<EquipartitionFit> fits;
  for (const Curve& curve : curves) {
    EquipartitionFit fit{.scheme = curve.scheme, .axes = {}, .configurational = {}};
    if (!curve.points.empty() && curve.points[0].order > 0) fit.order = curve.points[0].order;
    for (std::size_t k = 0; k < fit.axes.size(); ++k)
      fit.axes[k] =
          limit(points_of(curve, fit.order, [k](const auto& point) { return point.excess[k]; }));
    for (std::size_t k = 0; k < fit.configurational.size(); ++k)
      fit.configurational[k] = limit(points_of(
          curve, fit.order, [k](const auto& point) { return point.configurational_excess[k]; }));
    fits.push_back(fit);
  }
  return fits;
}

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
