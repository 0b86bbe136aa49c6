// SPDX-License-Identifier: MIT
// The heat flux of a fluid of rigid molecules, from which the thermal conductivity follows.
#pragma once

#include <memory>

#include "polhode/forces/laws/settings.hpp"
#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

struct FluidPairs;

/// Computes the heat flux of a fluid of one kind of molecule [evans1989],
///
///   J V = Σ_i e_i v_i + Σ_{i<j} ½ R_ij (F_ij·v_i + τ_ij·ω_i − F_ji·v_j − τ_ji·ω_j),
///
/// where e_i is the energy of a molecule with half of the energy of each of its pairs, and R_ij is
/// the vector from j to i. The total momentum must be zero. Constant energies, such as the
/// dispersion correction, are the same for all molecules and then carry no heat.
///
/// The function is a direct sum over all pairs and a mesh in double precision, so a call takes as
/// long as several force evaluations.
class HeatFlux {
 public:
  /// @param settings  force settings, with the mesh that is used, see ForceField::settings()
  /// @param share     part of the energy of a pair that belongs to its first molecule. The thermal
  ///   conductivity does not depend on it [marcolongo2016]; the mesh always has equal parts
  /// @throws Error  if there is more than one kind of molecule, or if there are external forces or
  ///   the dispersion of a slab, or PME without a mesh
  HeatFlux(const Topology& topology, const ForceSettings& settings, const Box& box,
           double share = 0.5);
  HeatFlux(HeatFlux&&) noexcept;
  ~HeatFlux();

  /// The heat flux times the volume [kJ/mol nm/ps].
  /// @throws Error  if the box of the state is not the box given to the constructor
  Vec3<double> operator()(const State& state);

 private:
  std::unique_ptr<FluidPairs> fluid_;
  double share_;
};

}  // namespace polhode
