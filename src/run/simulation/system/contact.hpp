// SPDX-License-Identifier: MIT
// Finds the two molecules that cause forces that are too large.
#pragma once

#include <string>

#include "polhode/run/simulation/system/system.hpp"

namespace polhode {

/// The strongest contact of a state as text, such as "molecules 3 (benzene) and 17 (benzene) are
/// 0.0931 nm apart, between H2 and C5". The first molecule is the molecule with the largest force,
/// or the first molecule with a force that is not finite. The second molecule has the site that is
/// closest to a site of the first molecule. Sites with neither mass nor a short-range potential are
/// ignored. The text is empty if the state or all forces are not finite, or if there is only one
/// molecule.
std::string strongest_contact(const System& system, const State& state);

}  // namespace polhode
