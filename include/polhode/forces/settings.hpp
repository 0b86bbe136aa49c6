// SPDX-License-Identifier: MIT
// What a user chooses about the forces. All molecules feel site-site Lennard-Jones and Coulomb
// forces in a periodic box; the choice is how they end at the cutoff, and in which precision pairs
// are computed.
#pragma once

#include <optional>

#include "polhode/forces/mesh_settings.hpp"
#include "polhode/forces/mixing.hpp"

namespace polhode {

/// How interactions end. The switches are smooth: fourth-order schemes need the third derivative
/// of the energy bounded.
enum class Truncation {
  molecule_switch,  ///< w(R) times all site pairs of two molecules, R between centres of mass
  site_switch,      ///< w(r) times each pair of sites, r between them
  site_shift,       ///< each pair of sites less its energy and force at the cutoff [toxvaerd2011]
};

/// What charges feel within the cutoff.
enum class Electrostatics {
  coulomb,               ///< Coulomb's law
  reaction_field,        ///< with a dielectric continuum beyond the cutoff
  ewald,                 ///< of all images: within the cutoff by pairs, the smooth rest on a mesh
  damped_shifted_force,  ///< Coulomb's law less a damping and what it is at the cutoff
};

/// In which numbers the pairs are computed. Positions, attitudes, momenta and all sums of forces,
/// torques and energies are double in both.
enum class Precision {
  full,   ///< pairs in double
  mixed,  ///< pairs in float: sites relative to centres, centres in fixed point
};

struct ForceSettings {
  Truncation truncation = Truncation::molecule_switch;
  double cutoff = 1.0;        ///< [nm]
  double switch_from = 0.85;  ///< where the switch begins [nm]
  int smoothness = 2;         ///< class of the switch: C¹, C², C³
  Electrostatics electrostatics = Electrostatics::coulomb;
  double dielectric = 78.5;  ///< beyond the cutoff, for the reaction field; may be infinite
  double skin = 0.05;        ///< of the neighbour list [nm]
  Precision precision = Precision::full;
  Mixing mixing{};  ///< of Lennard-Jones terms of unlike sites
  /// For Ewald's sum: the rms error of electrostatic forces over their rms.
  double accuracy = 1e-4;
  double damping = 2;  ///< of the damped shifted force: α [1/nm]
  /// For Ewald's sum: the mesh; without it, the cheapest of that accuracy.
  std::optional<MeshSettings> mesh{};
  /// Whether Lennard-Jones energy and pressure count what the truncation leaves out, for a uniform
  /// density of sites.
  bool dispersion_correction = false;
};

}  // namespace polhode
