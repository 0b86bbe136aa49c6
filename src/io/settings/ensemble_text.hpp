// SPDX-License-Identifier: MIT
// The settings of an ensemble as text.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "polhode/model/ensemble_settings.hpp"

namespace polhode {

/// Key and value of each setting in use, as in a run file; none at constant energy.
std::vector<std::pair<std::string, std::string>> ensemble_texts(const EnsembleSettings& settings);

/// The first setting out of its bounds, and what is wrong with it; empty if nothing.
std::string wrong_setting(const EnsembleSettings& settings);

/// "NVT, Langevin, friction 1 1/ps" for notes and reports.
std::string description(const EnsembleSettings& settings);

/// "xyz", or "xy z" for two groups.
std::string edges_text(const std::vector<CoupledEdges>& groups);

}  // namespace polhode
