// SPDX-License-Identifier: MIT
// The cheapest particle mesh for a given accuracy: the error expected from theory, and a search.
#pragma once

#include <map>
#include <string>
#include <tuple>

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

/// Chooses the fastest mesh whose rms force error is at most a given fraction of the rms
/// electrostatic force on a charge. The mesh is a function of the current box alone, and so is the
/// energy, as sampling at constant pressure requires.
class MeshChoice {
 public:
  /// @param cutoff  a of the split: pairs are summed up to it [nm]
  /// @throws Error  if the error is not from 1e-7 to 0.1, or there are no charges
  MeshChoice(const Topology& topology, double relative_error, double cutoff);

  /// The mesh for a box. Fast after the first call, because computed errors are stored.
  /// @throws Error  if the box holds so few charges that the mesh would have too many points
  MeshSettings operator()(const Box& box);

 private:
  MeshSettings cheapest(const Box& box);
  std::string remedy(const Box& box, double max_points) const;
  double error(double spacing, int order, int exponent);

  Topology topology_;
  double relative_error_, cutoff_;
  // The error in a box of 1 nm³, by spacing, order and exponent. It falls as V^(-1/2).
  std::map<std::tuple<double, int, int>, double> errors_;
};

/// The mesh for one box.
/// @throws Error  as MeshChoice
MeshSettings mesh_for(double relative_error, double cutoff, const Box& box,
                      const Topology& topology);

}  // namespace polhode
