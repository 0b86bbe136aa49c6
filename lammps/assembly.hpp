// SPDX-License-Identifier: MIT
// Assembles molecules with atoms on several processes. The number of a molecule determines the
// process that assembles it. The process that assembles a molecule receives all atoms of the
// molecule, and sends the results back to the processes of the atoms.
#pragma once

#include <mpi.h>

#include <cstdint>
#include <functional>
#include <vector>

#include "kinds.hpp"

namespace polhode::lammps {

/// A message about an atom, sent to the process of its molecule.
struct AtomMessage {
  std::int64_t molecule;  ///< number of the molecule, or minus the id of an atom without a molecule
  SiteAtom atom;
  int place;      ///< index of the atom on its process
  bool inside;    ///< whether the atom is in the group of the fix
  bool has_body;  ///< whether the atom is the owner of `body`
  BodyRecord body;
};

/// The reply to an AtomMessage: the kind and site of the atom, and its position and velocity in the
/// rigid body.
struct SiteMessage {
  int place, kind, site;
  std::int64_t owner;  ///< id of the atom that owns the body
  Vec3<double> x, v;
  BodyRecord body;  ///< data of the body, sent only to the owner atom
};

struct AssemblySettings {
  double tolerance = default_tolerance;
  /// Whether atoms may be away from the sites of their bodies, as within a gradient kick. While
  /// atoms are away from their sites, existing bodies are not changed.
  bool trust_bodies = false;
  /// Returns the periodic image of a difference vector that is nearest to zero.
  std::function<Vec3<double>(const Vec3<double>&)> minimum_image;
};

/// Finds the kinds of all molecules with an atom in the group, adds new kinds to the list, and
/// creates a body for each molecule. All processes of the communicator must call this function
/// together.
/// @param kinds  known kinds; the same on all processes, before and after the call
/// @return  messages for the atoms of this process that belong to bodies
/// @throws Error  on all processes, under the conditions of kind_of() and check_shape(), or if only
///   a part of a molecule is in the group
std::vector<SiteMessage> assemble(const std::vector<AtomMessage>& atoms, std::vector<Kind>& kinds,
                                  const AssemblySettings& settings, MPI_Comm world);

}  // namespace polhode::lammps
