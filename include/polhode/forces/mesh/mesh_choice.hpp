// SPDX-License-Identifier: MIT
// The cheapest particle mesh and charge cutoff for a given accuracy. Theory predicts the error,
// measurements predict the time, and a search finds the optimum.
#pragma once

#include <map>
#include <string>
#include <tuple>

#include "polhode/forces/laws/settings.hpp"
#include "polhode/forces/mesh/mesh_settings.hpp"
#include "polhode/model/box.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// Expected rms error of the force on a charge due to the mesh [kJ/mol/nm], for bodies with random
/// positions and orientations. The estimate of ballenegger2012 for independent charges is used. In
/// this estimate, the form factor of each body replaces the sum of squared charges, because the
/// charges of a neutral body largely cancel at long range.
double expected_mesh_error(const Topology& topology, const Box& box, const MeshSettings& settings);

/// A rough estimate of the rms electrostatic force on a charge in a dense liquid [kJ/mol/nm]. The
/// estimate is the force between two charges of rms size at the mean distance between charges.
double typical_force(const Topology& topology, const Box& box);

/// Chooses the fastest mesh whose rms force error is at most a given fraction of the rms
/// electrostatic force on a charge. The choice includes the grid, order and exponent, and the
/// cutoff of the charges unless the settings fix this cutoff. A shorter cutoff means fewer charge
/// pairs, but requires a finer mesh. The choice depends only on the settings and the current box.
/// The energy is therefore a function of the state, which barostats require.
class MeshChoice {
 public:
  /// @param settings  force settings with the accuracy and the cutoffs
  /// @throws Error  if the accuracy is not from 1e-7 to 0.1, or there are no charges
  MeshChoice(const Topology& topology, const ForceSettings& settings);

  /// Chooses the mesh for a box. All calls except the first are fast, because computed errors are
  /// stored.
  /// @throws Error  if the box holds so few charges that the mesh would have too many points
  MeshSettings operator()(const Box& box);

 private:
  struct Best {
    MeshSettings mesh;
    double seconds;
  };
  struct Orders {
    int first, last;
  };
  MeshSettings cheapest(const Box& box);
  void try_cutoff(double cutoff, Orders orders, const Box& box, Best& best);
  int coarsest(double cutoff, int order, int exponent, double required_in_unit_box);
  std::string remedy(const Box& box, const MeshSettings& best) const;
  double error(double cutoff, int spacing, int order, int exponent);

  Topology topology_;
  ForceSettings settings_;
  // Mesh errors in a box of 1 nm³, as a function of cutoff, grid spacing, order and exponent. The
  // mesh error scales with the box volume as V^(-1/2).
  std::map<std::tuple<double, int, int, int>, double> errors_;
};

/// Chooses the mesh for one box.
/// @throws Error  under the same conditions as MeshChoice
MeshSettings mesh_for(const ForceSettings& settings, const Box& box, const Topology& topology);

/// Chooses the mesh for one box and a given cutoff of the charges.
MeshSettings mesh_for(double relative_error, double cutoff, const Box& box,
                      const Topology& topology);

}  // namespace polhode
