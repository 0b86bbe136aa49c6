// SPDX-License-Identifier: MIT
// What a user chooses about the forces. All molecules feel site-site Lennard-Jones and Coulomb
// forces in a periodic box; the choice is how they end at the cutoff.
#pragma once

namespace polhode {

/// How interactions end. Both are smooth: fourth-order schemes need the third derivative of the
/// energy bounded.
enum class Truncation {
  molecule_switch,  ///< w(R) times all site pairs of two molecules, R between centres of mass
  reaction_field,   ///< site pairs: reaction field and Lennard-Jones, switched site by site
};

struct ForceSettings {
  Truncation truncation = Truncation::molecule_switch;
  double cutoff = 1.0;        ///< [nm]
  double switch_from = 0.85;  ///< where the switch begins [nm]
  int smoothness = 2;         ///< class of the switch: C¹, C², C³
  double dielectric = 78.5;   ///< beyond the cutoff, for the reaction field; may be infinite
  double skin = 0.1;          ///< of the neighbour list [nm]
};

}  // namespace polhode
