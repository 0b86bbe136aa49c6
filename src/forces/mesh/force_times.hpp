// SPDX-License-Identifier: MIT
// The expected time of a force evaluation with PME. The expected time determines the choice of
// charge cutoff and mesh. This time is a formula that does not depend on the processor, so the
// chosen mesh is the same on all computers.
#pragma once

#include "polhode/forces/laws/settings.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// Expected time of the mesh [s]. Without grid points, the result is the time to spread and gather
/// charges.
double expected_mesh_seconds(const Topology& topology, const MeshSettings& mesh);

/// Expected time of the pairs [s], for a given cutoff of the charges [nm].
double expected_pair_seconds(const Topology& topology, ForceSettings settings,
                             double coulomb_cutoff, const Box& box);

}  // namespace polhode
