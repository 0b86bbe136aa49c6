// SPDX-License-Identifier: MIT
#include "temperature_tables.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "polhode/io/output_units.hpp"

namespace polhode::cli {
namespace {

/// @param columns  the kinds of differences
/// @param at       the differences at a point
/// @param limits   the fitted lines
template <std::size_t n>
void print_excesses(const std::vector<Curve>& curves, const std::vector<EquipartitionFit>& fits,
                    const char* title, const std::array<const char*, n>& columns, const auto& at,
                    const auto& limits) {
  const auto known = [&](const EfficiencyPoint& p) {
    return std::any_of(at(p).begin(), at(p).end(), [](const auto& e) { return e.has_value(); });
  };
  if (std::none_of(curves.begin(), curves.end(), [&](const Curve& curve) {
        return std::any_of(curve.points.begin(), curve.points.end(), known);
      }))
    return;
  const auto text = [](const std::optional<Estimate>& e) {
    return e ? fmt::format("{:.2f} ± {:.2f}", e->value, e->error) : "-";
  };
  fmt::print("\n{} [K], and extrapolated to h = 0 by a + b h^k\n{:<18} {:>8}", title, "scheme",
             "step fs");
  for (const char* column : columns) fmt::print(" {:>16}", column);
  fmt::print("\n");
  for (std::size_t c = 0; c < curves.size(); ++c) {
    for (std::size_t i = 0; i < curves[c].usable; ++i) {
      const EfficiencyPoint& p = curves[c].points[i];
      fmt::print("{:<18} {:>8.3g}", p.scheme, p.step * units::fs_per_ps);
      for (const auto& excess : at(p)) fmt::print(" {:>16}", text(excess));
      fmt::print("\n");
    }
    fmt::print("{:<18} {:>8}", "", fmt::format("0, k = {}", fits[c].order));
    for (const std::optional<Line>& line : limits(fits[c]))
      fmt::print(" {:>16}", text(line ? std::optional(line->intercept) : std::nullopt));
    fmt::print("\n");
  }
}

nlohmann::json estimate_json(const std::optional<Estimate>& e) {
  if (!e) return {};
  return {{"value", e->value}, {"error", e->error}};
}

}  // namespace

void print_temperatures(const std::vector<Curve>& curves,
                        const std::vector<EquipartitionFit>& fits) {
  print_excesses<3>(
      curves, fits, "temperature of rotation about each principal axis minus that of translation",
      {"axis 1", "axis 2", "axis 3"},
      [](const EfficiencyPoint& p) -> const auto& { return p.excess; },
      [](const EquipartitionFit& fit) -> const auto& { return fit.axes; });
  print_excesses<4>(
      curves, fits, "configurational minus kinetic temperature of translation and of rotation",
      {"translation", "axis 1", "axis 2", "axis 3"},
      [](const EfficiencyPoint& p) -> const auto& { return p.configurational_excess; },
      [](const EquipartitionFit& fit) -> const auto& { return fit.configurational; });
}

void add_excesses(nlohmann::json& json, const EfficiencyPoint& point) {
  for (const auto& excess : point.excess) json["excess_K"].push_back(estimate_json(excess));
  for (const auto& excess : point.configurational_excess)
    json["configurational_excess_K"].push_back(estimate_json(excess));
}

void add_limits(nlohmann::json& json, const std::vector<EquipartitionFit>& fits) {
  const auto add = [&](const char* kind, const EquipartitionFit& fit, nlohmann::json motion,
                       const std::optional<Line>& line) {
    if (!line) return;
    json[kind].push_back({{"scheme", fit.scheme},
                          {"axis", std::move(motion)},
                          {"order", fit.order},
                          {"without_step_K", line->intercept.value},
                          {"without_step_error", line->intercept.error},
                          {"slope_K_per_ps_to_the_order", line->slope.value},
                          {"slope_error", line->slope.error}});
  };
  for (const EquipartitionFit& fit : fits) {
    for (std::size_t k = 0; k < fit.axes.size(); ++k) add("equipartition", fit, k + 1, fit.axes[k]);
    for (std::size_t k = 0; k < fit.configurational.size(); ++k)
      add("configurational", fit, k == 0 ? nlohmann::json() : nlohmann::json(k),
          fit.configurational[k]);
  }
}

void add_excess_columns(std::vector<Table::Column>& columns) {
  for (const char* axis : {"1", "2", "3"}) {
    columns.push_back({fmt::format("excess_{}", axis), "K"});
    columns.push_back({fmt::format("excess_{}_error", axis), "K"});
  }
  for (const char* motion : {"translation", "1", "2", "3"}) {
    columns.push_back({fmt::format("configurational_excess_{}", motion), "K"});
    columns.push_back({fmt::format("configurational_excess_{}_error", motion), "K"});
  }
}

void add_excesses(std::vector<Cell>& row, const EfficiencyPoint& point) {
  const auto add = [&](const std::optional<Estimate>& excess) {
    const Estimate known = excess.value_or(Estimate{std::nan(""), std::nan("")});
    row.insert(row.end(), {known.value, known.error});
  };
  for (const auto& excess : point.excess) add(excess);
  for (const auto& excess : point.configurational_excess) add(excess);
}

}  // namespace polhode::cli
