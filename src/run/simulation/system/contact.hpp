// SPDX-License-Identifier: MIT
// Which two molecules are to blame for forces that are too large.
#pragma once

#include <string>

#include "polhode/run/simulation/system/system.hpp"

namespace polhode {

/// "molecules 3 (benzene) and 17 (benzene) are 0.0931 nm apart, between H2 and C5": the molecule on
/// which the largest force acts, or the first one whose force is not finite, and the one with the
/// site closest to one of its sites, at the positions of a state. Sites that have neither mass nor
/// a short-range law do not count. Empty if the state or all of its forces are not finite, or if
/// there is only one molecule.
std::string strongest_contact(const System& system, const State& state);

}  // namespace polhode
