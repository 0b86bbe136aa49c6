// SPDX-License-Identifier: MIT
// The forces on the bodies of one domain of a larger system, for engines that divide space among
// processes and have the periodic images themselves.
#pragma once

#include <cstddef>
#include <memory>

#include "polhode/forces/laws/settings.hpp"
#include "polhode/model/load.hpp"
#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

struct AnyPairEngine;

/// Forces on the bodies of a domain, from each other and from ghosts. Ghosts are copies of
/// bodies of other domains, or periodic images, at explicit positions. The caller may make
/// space periodic in directions in which the domain extends over the whole box. Pairs of
/// two ghosts and the forces on ghosts are not computed. A pair of an own body with a ghost
/// has half of its energy and virial, because the domain of the other body has the other
/// half.
///
/// All ghosts that interact with an own body must be present. Their centres are within the cutoff
/// of its centre, plus the extents of both molecules unless the cutoff is between centres. Constant
/// terms are included for own bodies. The self-energy of charges is not included if it belongs to
/// the mesh of another program, see ForceSettings::ewald_alpha.
class DomainForces {
 public:
  /// @param own, ghosts  kinds and numbers of bodies; some numbers may be 0
  /// @param settings     without a mesh
  /// @param period       edges of the box [nm] in periodic directions, 0 in others
  /// @throws Error       if a setting is out of its domain, or a period too short: see
  ///                     is_long_enough()
  DomainForces(const Topology& own, const Topology& ghosts, const ForceSettings& settings,
               const Vec3<double>& period = {});
  DomainForces(DomainForces&&) noexcept;
  DomainForces& operator=(DomainForces&&) noexcept;
  ~DomainForces();

  /// Whether an edge of the box is long enough: each body interacts with at most one image of
  /// another body, and with no image of itself.
  static bool is_long_enough(double edge, const Topology& topology, const ForceSettings& settings);

  /// State of the bodies: own bodies, then ghosts, each in the order of their topology. Set q and
  /// orientation before each evaluation; the rest is not used.
  State& state() { return state_; }
  std::size_t own_bodies() const { return own_bodies_; }

  /// Forces and torques of the own bodies, the first ones of the Load; energies and virial too if
  /// `energies`, otherwise 0. Does not allocate, except when the list grows.
  void operator()(Load& load, bool energies);

 private:
  void enclose();

  std::size_t own_bodies_;
  Topology topology_;  // own parts, then those of ghosts
  ForceSettings settings_;
  double reach_;         // bodies farther apart do not interact and are not listed [nm]
  Vec3<double> period_;  // [nm], 0 where space is not periodic
  double constant_ = 0;  // of the own bodies [kJ/mol]
  State state_;
  std::unique_ptr<AnyPairEngine> engine_;
};

}  // namespace polhode
