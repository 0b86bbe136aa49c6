// SPDX-License-Identifier: MIT
// A rigid molecule: sites fixed in a body frame, and the inertia that follows from them.
#pragma once

#include <string>
#include <vector>

#include "polhode/base/vec3.hpp"
#include "polhode/model/short_range.hpp"

namespace polhode {

/// One interaction or mass point of a rigid molecule.
struct Site {
  std::string name;     ///< name as in coordinate files: "OW", "HW1"
  std::string element;  ///< chemical symbol; empty for massless sites
  Vec3<double> r;       ///< position in the body frame [nm]
  double mass = 0;      ///< [u]
  double charge = 0;    ///< [e]
  double sigma = 0;     ///< diameter of Lennard-Jones and Mie laws [nm]
  double epsilon = 0;   ///< their well depth [kJ/mol]
  ShortRangeLaw law{};

  bool has_short_range() const { return !is_zero(epsilon, law); }
};

/// Type of rigid body, by its principal moments.
enum class Top { atom, linear, spherical, symmetric, asymmetric };

const char* name(Top top);

struct Molecule {
  std::string name;
  std::string description;
  std::string source;       ///< key in docs/references.bib
  std::vector<Site> sites;  ///< sites in the principal frame, with the origin at the centre of mass
  double mass = 0;          ///< [u]
  Vec3<double> J;  ///< principal moments [u nm²], J1 ≤ J2 ≤ J3; linear J1 = 0, atom all 0
  Top top = Top::atom;

  double charge() const;  ///< [e]
  double dipole() const;  ///< |Σ q r| about the centre of mass [e nm]
  double extent() const;  ///< largest distance of an interacting site from the centre [nm]
};

/// Builds the molecule from a set of sites given in any frame: mass, centre, principal moments and
/// axes are computed and the sites are transformed into the principal frame (right-handed).
///
/// @throws Error  if no site has mass, or a number of a site is not finite or out of its domain
Molecule rigid_molecule(std::string name, std::vector<Site> sites);

}  // namespace polhode
