// SPDX-License-Identifier: MIT
// The virial of each molecule, from which profiles of the pressure follow.
#pragma once

#include <memory>

#include "polhode/base/column.hpp"
#include "polhode/forces/laws/settings.hpp"
#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// Computes the virials of the molecules of a fluid of one kind, w_i = ½ Σ_j R_ij F_ij for each of
/// the three axes. R_ij is the vector from j to i, and F_ij the force on i. Each molecule of a pair
/// has half of the virial. If the virials parallel to a surface are assigned to the places of their
/// molecules, they give the tangential pressure with the contour of Harasima [harasima1958].
///
/// In the mesh part, two charges share their virial in the same way. The part −Σ d_a F_a belongs to
/// the molecule with the arms d_a. Terms that do not depend on the configuration belong to all
/// molecules equally. The sum of all virials is the diagonal of Load::virial.
///
/// The function is a direct sum over all pairs and a mesh in double precision, so a call takes as
/// long as several force evaluations.
class MolecularVirials {
 public:
  /// @param settings  force settings, with the mesh that is used, see ForceField::settings()
  /// @throws Error  if there is more than one kind of molecule, or if there are external forces, or
  ///   PME without a mesh
  MolecularVirials(const Topology& topology, const ForceSettings& settings, const Box& box);
  MolecularVirials(MolecularVirials&&) noexcept;
  ~MolecularVirials();

  /// The virials along x, y and z of each molecule [kJ/mol].
  /// @throws Error  if the box of the state is not the box given to the constructor
  const Vec3Column& operator()(const State& state);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace polhode
