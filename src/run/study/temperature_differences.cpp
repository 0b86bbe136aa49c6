// SPDX-License-Identifier: MIT
#include "temperature_differences.hpp"

#include <fmt/core.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

namespace polhode {
namespace {

nlohmann::json estimate_json(const std::optional<Estimate>& e) {
  if (!e) return {};
  return {{"value", e->value}, {"error", e->error}};
}

}  // namespace

void add_excesses(nlohmann::json& json, const EfficiencyPoint& point) {
  for (const auto& excess : point.excess) json["excess_K"].push_back(estimate_json(excess));
  for (const auto& excess : point.configurational_excess)
    json["configurational_excess_K"].push_back(estimate_json(excess));
}

void add_limits(nlohmann::json& json, const std::vector<EquipartitionFit>& fits) {
  const auto add = [&](const char* kind, const EquipartitionFit& fit, nlohmann::json motion,
                       const std::optional<Line>& line) {
    if (!line) return;
    json[kind].push_back(
        {{"scheme", fit.scheme},
         {"axis", std::move(motion)},
         {"order", fit.order},
         {"without_step_K", line->intercept.value},
         {"without_step_error", line->intercept.error},
         {"slope_K_per_ps_to_the_order", line->slope.value},
         {"slope_error", line->slope.error},
         {"degrees_of_freedom", line->degrees_of_freedom},
         {"without_step_p_value", p_value(line->intercept, line->degrees_of_freedom)}});
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

}  // namespace polhode
