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
class SlabDispersion;

/// Energy terms that do not depend on the positions of the bodies [kJ/mol], and the virial of these
/// terms.
struct ConstantTerms {
  double dispersion = 0;                                ///< long-range dispersion correction
  double self = 0, intramolecular = 0, background = 0;  ///< self-energy of the charges, exclusions
                                                        ///< within bodies, and neutralizing
                                                        ///< background
  Mat3<double> virial{};
  double coulomb() const { return self + intramolecular + background; }
};

/// State of the neighbour list. The positions at the last rebuild determine the list. The list
/// determines the summation order of the forces, and therefore their last bits.
struct ListMemory {
  Vec3Column built_at;       ///< centre of each body at the last rebuild [nm]; empty if there is no
                             ///< list for the box of the state
  std::size_t rebuilds = 0;  ///< number of rebuilds so far
};

/// Computes site-site Lennard-Jones and Coulomb forces of rigid molecules in the periodic box of
/// the state. After a change of the box, the list and everything else that depends on the box is
/// rebuilt. After such a rebuild, results are bitwise identical to the results of a force field
/// constructed for the new box. An evaluation throws an Error if the box is too small for the
/// cutoff, or if it needs a mesh with too many points.
///
/// ExternalForces of the settings are added to the forces of the force field. The derivative of
/// external forces is a central difference.
///
/// The points of a mesh are fixed in space, so the mesh exerts a net force. remove_net_force()
/// subtracts this net force, so that the total momentum is conserved. After this subtraction, the
/// forces are minus the gradient of the energy along every motion that leaves the centre of mass at
/// rest.
class ForceField {
 public:
  /// @param box      box of the first state, used to check the settings
  /// @param workers  threads that share an evaluation; results do not depend on their number
  /// @param choice   mesh_choice() of another force field with the same topology and settings. This
  ///   choice saves time and does not change results
  /// @throws Error   if the cutoff does not fit into the box, or a setting is out of its domain
  ForceField(const Topology& topology, const ForceSettings& settings, const Box& box,
             Workers& workers = Workers::serial(), std::optional<MeshChoice> choice = {});
  ForceField(ForceField&&) noexcept;
  ~ForceField();

  /// Computes forces, torques, energies and virial of a state. Does not allocate memory, except
  /// when the list grows.
  void operator()(const State& state, Load& load) { evaluate(state, load, true); }
  /// Computes only forces and torques, which is faster; energies and virial are set to 0.
  void forces_alone(const State& state, Load& load) { evaluate(state, load, false); }

  /// Computes the exact derivative of forces and torques along a displacement of all bodies.
  /// Centres move by dq [nm], and orientations rotate by the body-frame vectors dtheta [rad]. f and
  /// tau of the result are derivatives per unit displacement, in the lab frame; its energies and
  /// virial are 0. The function uses the neighbour list and loops of the forces. The derivative is
  /// cheapest at the state of the last evaluation, because the mesh potential is then reused. The
  /// function does not allocate memory after its first call.
  void directional_derivative(const State& state, const Vec3Column& dq, const Vec3Column& dtheta,
                              Load& slope);

  /// The state of the neighbour list, for checkpoints.
  /// @param box  box of the current state
  ListMemory list_memory(const Box& box) const;
  /// Rebuilds the list from the positions in `memory`. The rebuilt list gives bitwise the same
  /// forces as the force field from which `memory` was taken.
  /// @param box  box of the state from which the run resumes
  void resume_from(const ListMemory& memory, const Box& box);

  std::uint64_t evaluations() const { return evaluations_; }
  /// Number of rebuilds of the neighbour list, including rebuilds before the list was restored.
  std::size_t list_rebuilds() const;
  const NeighbourList& neighbours() const;
  /// The settings in use. With PME, the settings include the mesh that was chosen for the box.
  const ForceSettings& settings() const { return settings_; }
  /// Energies that do not depend on the positions of the bodies, in the box of the last state.
  const ConstantTerms& constant_terms() const { return constant_; }
  const Topology& topology() const { return topology_; }
  /// The choice of meshes with all computed errors; empty without a chosen mesh.
  const std::optional<MeshChoice>& mesh_choice() const { return mesh_choice_; }

 private:
  void set_box(const Box& box);
  void evaluate(const State& state, Load& load, bool energies);
  void set_slab(const Box& box);

  Workers& workers_;
  Topology topology_;
  Bodies bodies_;
  std::optional<MeshChoice> mesh_choice_;  // empty until a mesh is chosen
  ForceSettings settings_;
  std::optional<Box> box_;  // box for which the members below were built; empty after an Error
  double tail_ = 0;         // dispersion correction times volume, equal for all boxes [kJ/mol nm³]
  ConstantTerms constant_;
  std::unique_ptr<SlabDispersion> slab_;  // null without slab_dispersion
  std::unique_ptr<AnyPairEngine> engine_;
  std::uint64_t evaluations_ = 0;
  std::size_t earlier_rebuilds_ = 0;
};

}  // namespace polhode
