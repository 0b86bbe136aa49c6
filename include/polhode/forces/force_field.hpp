// SPDX-License-Identifier: MIT
// The forces of a system, State → Load, computed with a neighbour list and packs.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "polhode/base/workers.hpp"
#include "polhode/forces/mesh/mesh_choice.hpp"
#include "polhode/model/load.hpp"
#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

struct AnyPairEngine;
class NeighbourList;

/// Energies that do not depend on the positions of the bodies [kJ/mol], and their virial.
struct ConstantTerms {
  double dispersion = 0;                                ///< long-range dispersion correction
  double self = 0, intramolecular = 0, background = 0;  ///< see SelfInteraction, MeshConstant
  Mat3<double> virial{};
  double coulomb() const { return self + intramolecular + background; }
};

/// The neighbour list, on which the last bits of the forces depend besides the state. The positions
/// from which it was built determine it.
struct ListMemory {
  Vec3Column built_at;       ///< centre of each body at that time [nm]; empty if there is no list
                             ///< for the box of the state
  std::size_t rebuilds = 0;  ///< number of rebuilds so far
};

/// Site-site Lennard-Jones and Coulomb forces of rigid molecules in the periodic box of the state.
/// If the box has changed since the last evaluation, the list and everything else that depends on
/// it is built again. Every result equals the result of a force field constructed for the box, to
/// the last bit. An evaluation throws an Error if the box has become too small for the cutoff, or
/// needs a mesh with too many points.
///
/// ExternalForces of the settings are added to the others. Their derivative is a central
/// difference.
///
/// The points of a mesh are fixed in space, so the mesh exerts a net force.
/// remove_net_force() removes it, so that the forces conserve the total momentum. The forces
/// are minus the gradient of the energy along every motion that leaves the centre of mass at
/// rest.
class ForceField {
 public:
  /// @param box      of the first state, for which the settings are checked
  /// @param workers  threads that share an evaluation; results do not depend on their number
  /// @throws Error   if the cutoff does not fit into the box, or a setting is out of its domain
  ForceField(const Topology& topology, const ForceSettings& settings, const Box& box,
             Workers& workers = Workers::serial());
  ForceField(ForceField&&) noexcept;
  ~ForceField();

  /// Forces, torques, energies and virial of a state. Does not allocate, except when the list
  /// grows.
  void operator()(const State& state, Load& load) { evaluate(state, load, true); }
  /// Forces and torques only, which is faster; energies and virial are set to 0.
  void forces_alone(const State& state, Load& load) { evaluate(state, load, false); }

  /// The exact derivative of forces and torques along a displacement of all bodies: centres move by
  /// dq [nm], orientations rotate by the body-frame vectors dtheta [rad]. f and tau of the result
  /// are per unit of the displacement, in the lab frame; its energies and virial are 0. Uses the
  /// same list and loops as the forces; cheapest at the state of the last evaluation, whose mesh
  /// potential is reused. Does not allocate after the first call.
  void directional_derivative(const State& state, const Vec3Column& dq, const Vec3Column& dtheta,
                              Load& slope);

  /// @param box  of the state
  ListMemory list_memory(const Box& box) const;
  /// Rebuilds the list from the positions in `memory`. The forces then agree to the last bit with
  /// the force field from which the memory was taken.
  /// @param box  of the state from which the run resumes
  void resume_from(const ListMemory& memory, const Box& box);

  std::uint64_t evaluations() const { return evaluations_; }
  /// Rebuilds of the neighbour list, including those before it was restored.
  std::size_t list_rebuilds() const;
  const NeighbourList& neighbours() const;
  /// The settings in use; with PME, including the mesh that was chosen for the box.
  const ForceSettings& settings() const { return settings_; }
  /// Terms that do not depend on the positions of the bodies, in the box of the last state.
  const ConstantTerms& constant_terms() const { return constant_; }
  const Topology& topology() const { return topology_; }

 private:
  void set_box(const Box& box);
  void evaluate(const State& state, Load& load, bool energies);
  void add_external(const State& state, Load& load, bool energies);

  Workers& workers_;
  Topology topology_;
  Bodies bodies_;
  std::optional<MeshChoice> mesh_choice_;  // once a mesh was chosen
  ForceSettings settings_;
  std::optional<Box> box_;  // of all that follows; none after an Error
  double tail_ = 0;         // of the dispersion, in any box [kJ/mol nm³]
  ConstantTerms constant_;
  std::unique_ptr<AnyPairEngine> engine_;
  std::uint64_t evaluations_ = 0;
  std::size_t earlier_rebuilds_ = 0;
};

}  // namespace polhode
