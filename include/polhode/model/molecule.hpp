// SPDX-License-Identifier: MIT
// A rigid molecule: sites fixed in a body frame, and the mass and moments of inertia of these
// sites.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "polhode/base/vec3.hpp"
#include "polhode/model/short_range.hpp"

namespace polhode {

/// An interaction site or point mass of a rigid molecule.
struct Site {
  std::string name;     ///< name as in coordinate files, such as "OW" or "HW1"
  std::string element;  ///< chemical symbol; empty for massless sites
  Vec3<double> r;       ///< position in the body frame [nm]
  double mass = 0;      ///< mass [u]
  double charge = 0;    ///< charge [e]
  double sigma = 0;     ///< diameter of Lennard-Jones and Mie potentials [nm]
  double epsilon = 0;   ///< well depth of Lennard-Jones and Mie potentials [kJ/mol]
  ShortRangeLaw law{};
  /// Factor of the distances in its short-range potentials, after mixing. It is below 1 in a
  /// molecule that is coupled to the others only in part.
  double size = 1;

  bool has_short_range() const { return !is_zero(epsilon, law); }
};

/// Types of rigid bodies, classified by their principal moments of inertia.
enum class Top { atom, linear, spherical, symmetric, asymmetric };

const char* name(Top top);

struct Molecule {
  std::string name;
  std::string description;
  std::string source;       ///< key in docs/references.bib
  std::vector<Site> sites;  ///< sites in the principal frame, with the origin at the centre of mass
  double mass = 0;          ///< total mass [u]
  Vec3<double> J;  ///< principal moments of inertia [u nm²], J1 ≤ J2 ≤ J3; J1 = 0 for a linear
                   ///< molecule, all are 0 for an atom
  Top top = Top::atom;
  std::optional<MixingRule> mixing{};  ///< rule with which the model was parametrized; empty if its
                                       ///< file gives none

  double charge() const;  ///< Total charge [e].
  double dipole() const;  ///< Dipole moment |Σ q r| about the centre of mass [e nm].
  double extent() const;  ///< Largest distance of an interacting site from the centre of mass [nm].
};

/// Builds a molecule from sites that are given in any frame. The function computes mass, centre,
/// principal moments and axes, and transforms the sites into the right-handed principal frame.
///
/// @throws Error  if no site has mass, or if a number of a site is not finite or is out of its
///   domain
Molecule rigid_molecule(std::string name, std::vector<Site> sites);

}  // namespace polhode
