// SPDX-License-Identifier: MIT
// Differences between the temperatures of translation and rotation, kinetic and configurational, as
// functions of the step and for zero step: in the JSON and the tables of a study and of the
// adviser.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "polhode/io/files/table_file.hpp"
#include "run/study/equipartition.hpp"

namespace polhode {

/// The differences at a point: "excess_K", rotation about each axis minus translation, and
/// "configurational_excess_K" of each kind of motion.
void add_excesses(nlohmann::json& json, const EfficiencyPoint& point);
/// Their limits for zero step: "equipartition" and "configurational".
void add_limits(nlohmann::json& json, const std::vector<EquipartitionFit>& fits);

/// The differences as table columns, and as fields of a row.
void add_excess_columns(std::vector<Table::Column>& columns);
void add_excesses(std::vector<Cell>& row, const EfficiencyPoint& point);

}  // namespace polhode
