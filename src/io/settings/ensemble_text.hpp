// SPDX-License-Identifier: MIT
// The settings of an ensemble as text.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "polhode/model/ensemble_settings.hpp"

namespace polhode {

/// The key and value of each ensemble setting in use, as in a run file. At constant energy there
/// are no ensemble settings.
std::vector<std::pair<std::string, std::string>> ensemble_texts(const EnsembleSettings& settings);

/// A description of the first ensemble setting that is out of its bounds; empty if all are valid.
std::string wrong_setting(const EnsembleSettings& settings);

/// The ensemble as text for notes and reports, such as "300 K, Langevin thermostat with a friction
/// of 1 1/ps".
std::string description(const EnsembleSettings& settings);

/// Groups of coupled edges as text: "xyz", or "xy z" for two groups.
std::string edges_text(const std::vector<CoupledEdges>& groups);

}  // namespace polhode
