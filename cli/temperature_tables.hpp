// SPDX-License-Identifier: MIT
// How far the temperatures of translation and rotation, kinetic and configurational, are apart with
// a step and without: for the page of text, JSON and tables of a study and of the adviser.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "polhode/io/table_file.hpp"
#include "polhode/run/equipartition.hpp"

namespace polhode::cli {

/// Differences of temperatures by scheme and step, and without a step; nothing if none is known.
/// @param fits  of the curves, in their order
void print_temperatures(const std::vector<Curve>& curves,
                        const std::vector<EquipartitionFit>& fits);

/// The differences at a point: "excess_K" of rotation about each axis less translation, and
/// "configurational_excess_K" of each motion.
void add_excesses(nlohmann::json& json, const EfficiencyPoint& point);
/// Their limits without a step: "equipartition" and "configurational".
void add_limits(nlohmann::json& json, const std::vector<EquipartitionFit>& fits);

/// The differences as columns, and as fields of a row.
void add_excess_columns(std::vector<Table::Column>& columns);
void add_excesses(std::vector<Cell>& row, const EfficiencyPoint& point);

}  // namespace polhode::cli
