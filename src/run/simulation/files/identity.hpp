// SPDX-License-Identifier: MIT
// The identity of a run or a study as text, so that results of different ones are never mixed.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include "polhode/run/simulation/system/system.hpp"

namespace polhode {

/// Molecules with all their parameters, the initial configuration, and the forces.
/// @param numbers  further parameters of the computation, such as times
std::string identity(const Config& config, const System& system,
                     std::initializer_list<double> numbers);

/// The settings that a run depends on besides its system, one a line: "integrator.step = 2 fs".
std::string settings_text(const Config& config);

/// Whether two identities, a hash with settings_text() below it, are of the same run.
bool same_run(std::string_view one, std::string_view other);

/// What differs between the settings in two such texts: "integrator.step was 2 fs and is now 1 fs";
/// empty if nothing.
std::string differences(const std::string& then, const std::string& now);

}  // namespace polhode
