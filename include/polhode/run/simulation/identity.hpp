// SPDX-License-Identifier: MIT
// The identity of a run or a study as text, so that results of different ones are never mixed.
#pragma once

#include <initializer_list>
#include <string>

#include "polhode/run/simulation/system.hpp"

namespace polhode {

/// Molecules with all their parameters, the initial configuration, and the forces.
/// @param numbers  further parameters of the computation, such as times
std::string identity(const Config& config, const System& system,
                     std::initializer_list<double> numbers);

}  // namespace polhode
