// SPDX-License-Identifier: MIT
// The identity of a run or a study as text, so that results of different runs or studies are never
// mixed.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "polhode/run/simulation/system/system.hpp"

namespace polhode {

/// The identity of a computation as a text that contains molecules with all their parameters, the
/// initial configuration, and the forces.
/// @param numbers  further parameters of the computation, such as times
std::string identity(const Config& config, const System& system,
                     const std::vector<double>& numbers);

/// The settings, other than the system, that determine a run. Each setting is a line such as
/// "integrator.step = 2 fs".
std::string settings_text(const Config& config);

/// Whether two identities belong to the same run; each is a hash followed by settings_text().
bool same_run(std::string_view one, std::string_view other);

/// The differences between the settings in two identities, such as "integrator.step was 2 fs and is
/// now 1 fs". The text is empty if there are no differences.
std::string differences(const std::string& then, const std::string& now);

}  // namespace polhode
