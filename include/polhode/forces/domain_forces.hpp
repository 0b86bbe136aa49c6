// SPDX-License-Identifier: MIT
// The forces on the bodies of one domain of a larger system, for engines that divide space among
// processes and supply the periodic images.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "polhode/forces/laws/settings.hpp"
#include "polhode/model/load.hpp"
#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

struct AnyPairEngine;

/// Computes the forces of the pairs of a domain: pairs of two bodies of the domain, which are
/// called local bodies, and pairs of a local body and a ghost. Ghosts are copies of bodies of other
/// domains, or periodic images, at explicit positions. Pairs of two ghosts are left out. A caller
/// can treat a direction as periodic if the domain extends over the whole box in this direction.
///
/// The caller must give each pair of bodies of different domains to exactly one of them. The domain
/// has a ghost for the other body, and the caller adds the forces on the ghost to those of the
/// body. If the cutoff applies to sites, a ghost can interact if the distance of the centres is
/// below the cutoff plus the extents of both molecules. Constant energies of local bodies are
/// included. The self-energy of charges is omitted if another program computes the mesh and adds
/// the self-energy, see ForceSettings::ewald_alpha.
class DomainForces {
 public:
  /// @param own          kinds of molecules and numbers of local bodies; some numbers may be 0
  /// @param ghosts       number of ghosts of each of these kinds; empty if there are none
  /// @param settings     force settings without a mesh
  /// @param period       box edges [nm] in periodic directions, 0 in other directions
  /// @throws Error       if a setting is out of its domain, if the number of kinds differs, or if a
  ///   period is too short: see is_long_enough()
  DomainForces(const Topology& own, const std::vector<std::size_t>& ghosts,
               const ForceSettings& settings, const Vec3<double>& period = {});
  DomainForces(DomainForces&&) noexcept;
  DomainForces& operator=(DomainForces&&) noexcept;
  ~DomainForces();

  /// Whether a box edge is so long that each body interacts with at most one image of another body,
  /// and with no image of itself.
  static bool is_long_enough(double edge, const Topology& topology, const ForceSettings& settings);

  /// State of all bodies: local bodies first, then ghosts, each in the order of their topology. The
  /// caller sets q and orientation before each evaluation; the other members are not used.
  State& state() { return state_; }
  std::size_t own_bodies() const { return own_bodies_; }
  /// Sets other box edges in the periodic directions, for example after a move of a barostat.
  /// @pre  the same directions are periodic as before
  void set_period(const Vec3<double>& period);

  /// Computes the forces and torques on local bodies and ghosts, in the order of the state. If
  /// `energies` is true, the energies and the virial of all pairs are computed as well; otherwise
  /// they are 0. Does not allocate memory, except when the list grows.
  void operator()(Load& load, bool energies);

 private:
  void set_box(const Box& box);
  void enclose();

  std::size_t own_bodies_;
  Topology topology_;  // parts of the local bodies, followed by the parts of the ghosts
  ForceSettings settings_;
  double reach_;         // cutoff of the list: bodies farther apart do not interact [nm]
  Vec3<double> period_;  // box edges in periodic directions, otherwise 0 [nm]
  State state_;
  double constant_;  // constant energy of the local bodies [kJ/mol]
  std::unique_ptr<AnyPairEngine> engine_;
};

}  // namespace polhode
