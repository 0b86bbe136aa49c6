// SPDX-License-Identifier: MIT
// The expected time of an evaluation of forces with PME, from which the cutoff of the
// charges and the mesh are chosen. It does not depend on the processor, and neither do results.
#pragma once

#include "polhode/forces/laws/settings.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// Time of the mesh [s]; without grid points, that of spreading and gathering.
double expected_mesh_seconds(const Topology& topology, const MeshSettings& mesh);

/// Time of the pairs [s], with a given cutoff of the charges [nm].
double expected_pair_seconds(const Topology& topology, ForceSettings settings,
                             double coulomb_cutoff, const Box& box);

}  // namespace polhode
