// SPDX-License-Identifier: MIT
// The distances at which short-range potentials are defined.
#pragma once

#include <string>

#include "polhode/forces/laws/settings.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// The distance below which a law is not defined [nm]: the maximum of the Buckingham potential, or
/// the start of a table. For all other laws, this distance is 0.
double inner_limit(const ShortRangeLaw& law);

/// A note for the message about an energy that is not finite, such as "; two argon.Ar sites may
/// have come closer than 0.0775 nm, the shortest distance at which their potential is valid". The
/// note is empty if all laws are defined at all distances.
std::string inner_limit_note(const Topology& topology);

/// Checks that tabulated potentials cover all distances up to the cutoff.
/// @throws Error  if a table ends before the cutoff or, with a molecule switch, before the largest
///   distance between two sites of molecules within the cutoff
void check_tables(const Topology& topology, const ForceSettings& settings);

}  // namespace polhode
