// SPDX-License-Identifier: MIT
// The forces of a system: State → Load, over a neighbour list, in packs.
#pragma once

#include <cstdint>

#include "polhode/forces/neighbours.hpp"
#include "polhode/forces/pair_loops.hpp"
#include "polhode/forces/pair_table.hpp"
#include "polhode/model/load.hpp"
#include "polhode/model/state.hpp"

namespace polhode {

/// Site-site Lennard-Jones and Coulomb forces of rigid molecules in a periodic box.
class ForceField {
 public:
  /// @throws Error  if the cutoff does not fit the box, or a setting is out of its domain
  ForceField(const Topology& topology, const ForceSettings& settings, const Box& box);

  /// Forces, torques and energies of a state. Does not allocate, except where the list grows.
  void operator()(const State& state, Load& load);

  /// The exact derivative of forces and torques along a displacement of all bodies: centres move by
  /// dq [nm], attitudes turn by the body-frame vectors dtheta [rad]. The result is a Load whose f
  /// and tau are per unit of the displacement, and whose energies are their derivatives.
  /// Computed over all pairs with dual numbers: for checks and single points.
  Load directional_derivative(const State& state, const Vec3Column& dq,
                              const Vec3Column& dtheta) const;

  std::uint64_t evaluations() const { return evaluations_; }
  const NeighbourList& neighbours() const { return list_; }
  const ForceSettings& settings() const { return settings_; }
  const Topology& topology() const { return topology_; }

 private:
  Topology topology_;
  ForceSettings settings_;
  PairTables tables_;
  PairLaws laws_;
  NeighbourList list_;
  std::vector<std::vector<Vec3<double>>> sites_;  // per part, in the order of Arms, body frame
  std::vector<std::size_t> first_;                // first body of each part, and the end
  ArmRecords arms_;
  std::vector<Vec3<double>> shifts_;
  PartnerBuffer buffer_;
  std::uint64_t evaluations_ = 0;
};

}  // namespace polhode
