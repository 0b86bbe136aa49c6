// SPDX-License-Identifier: MIT
// The cheapest particle mesh of an accuracy: the error that theory expects, and a search.
#pragma once

#include "polhode/forces/mesh_settings.hpp"
#include "polhode/model/box.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// The rms error of the force on a charge that a mesh makes [kJ/mol/nm], for bodies that are placed
/// and turned at random: the mean square of ballenegger2012 for charges, with the form factor of
/// each body in the place of its charges' squares, for charges of a neutral body do not act far.
double expected_mesh_error(const Topology& topology, const Box& box, const MeshSettings& settings);

/// About what the rms electrostatic force on a charge is in a dense liquid [kJ/mol/nm]: that of the
/// mean square charge at the mean distance of charges.
double typical_force(const Topology& topology, const Box& box);

/// The mesh that takes the least time among those whose forces err by `relative_error` of the
/// electrostatic force on a charge, both rms.
/// @param cutoff  a of the split: pairs are summed up to there [nm]
/// @throws Error  if the error is not from 1e-7 to 0.1, no charge is there, or so few in so large a
///                box that the mesh would be far larger than they are worth
MeshSettings mesh_for(double relative_error, double cutoff, const Box& box,
                      const Topology& topology);

}  // namespace polhode
