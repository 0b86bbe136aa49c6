// SPDX-License-Identifier: MIT
// The cheapest particle mesh for a given accuracy: the error expected from theory, and a search.
#pragma once

#include "polhode/forces/mesh/mesh_settings.hpp"
#include "polhode/model/box.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// Expected rms error of the force on a charge due to the mesh [kJ/mol/nm], for bodies with random
/// positions and attitudes: the mean square error of ballenegger2012 for independent charges, with
/// the form factor of each body in place of the sum of its squared charges, since the charges of a
/// neutral body largely cancel at long range.
double expected_mesh_error(const Topology& topology, const Box& box, const MeshSettings& settings);

/// Rough estimate of the rms electrostatic force on a charge in a dense liquid [kJ/mol/nm]: the
/// force of the mean square charge at the mean distance between charges.
double typical_force(const Topology& topology, const Box& box);

/// The fastest mesh whose rms force error is at most `relative_error` times the rms electrostatic
/// force on a charge.
/// @param cutoff  a of the split: pairs are summed up to it [nm]
/// @throws Error  if the error is not from 1e-7 to 0.1, or there are no charges
MeshSettings mesh_for(double relative_error, double cutoff, const Box& box,
                      const Topology& topology);

}  // namespace polhode
