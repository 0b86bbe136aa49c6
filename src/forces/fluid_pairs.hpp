// SPDX-License-Identifier: MIT
// The pairs of a fluid of one kind of molecule, for sums that are computed from time to time.
#pragma once

#include <optional>
#include <string_view>

#include "forces/mesh/mesh_heat_flux.hpp"
#include "forces/pairs/pair_heat_flux.hpp"
#include "polhode/forces/laws/settings.hpp"
#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// The sites, laws and motion of the molecules, and a mesh for PME.
struct FluidPairs {
  /// @param what  quantity that is computed, for errors
  /// @throws Error  if there is more than one kind of molecule, or if there are external forces, or
  ///   PME without a mesh
  FluidPairs(const Topology& topology, const ForceSettings& settings, const Box& box,
             std::string_view what);

  /// Sets the positions of all sites.
  /// @throws Error  if the box of the state is not the box given to the constructor
  void place(const State& state);
  /// Sets the positions and velocities.
  void set_motion(const State& state);
  PairHeatFluxJob job(double share) const {
    return {tables(0, 0), laws, treatment, motion, box.edge, range, share};
  }

  std::string_view what;
  Box box;
  Bodies bodies;
  InteractionSites sites;
  PairTables tables;
  PairLaws<double> laws;
  CutoffTreatment treatment;
  double range;
  std::optional<MeshHeatFlux> mesh{};
  Motion motion{};
};

}  // namespace polhode
