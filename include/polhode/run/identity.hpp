// SPDX-License-Identifier: MIT
// What a run or a study is, as a text: what was computed of one thing is not mixed with another.
#pragma once

#include <initializer_list>
#include <string>

#include "polhode/run/system.hpp"

namespace polhode {

/// Molecules with all their numbers, the start, and the forces.
/// @param numbers  that say what is done with them: times, above all
std::string identity(const Config& config, const System& system,
                     std::initializer_list<double> numbers);

}  // namespace polhode
