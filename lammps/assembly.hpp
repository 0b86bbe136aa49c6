// SPDX-License-Identifier: MIT
// Assembles molecules whose atoms belong to several processes: every molecule is dealt with by the
// process that its number selects, which receives all its atoms, and answers to where they are.
#pragma once

#include <mpi.h>

#include <cstdint>
#include <functional>
#include <vector>

#include "kinds.hpp"

namespace polhode::lammps {

/// An atom on its way to the process of its molecule.
struct AtomMessage {
  std::int64_t molecule;  ///< minus the atom's id for an atom without a molecule
  SiteAtom atom;
  int place;      ///< index of the atom where it belongs
  bool inside;    ///< whether it is in the group of the fix
  bool has_body;  ///< whether it is an owner, with the body below
  BodyRecord body;
};

/// The answer: which site of which kind an atom is, and where the rigid body has it.
struct SiteMessage {
  int place, kind, site;
  std::int64_t owner;  ///< id of the atom that owns the body
  Vec3<double> x, v;
  BodyRecord body;  ///< for the owner
};

struct AssemblySettings {
  double tolerance = default_tolerance;
  /// Whether atoms may be elsewhere than their bodies, as within a gradient kick: then bodies
  /// that exist are kept as they are.
  bool trust_bodies = false;
  /// The periodic image of a difference that is nearest to zero.
  std::function<Vec3<double>(const Vec3<double>&)> minimum_image;
};

/// Finds the kinds of all molecules with an atom inside, adds new ones to the known ones, and gives
/// each molecule a body. All processes of the communicator call it together.
/// @param kinds  the known ones; the same on all processes, before and after
/// @return  for the atoms of this process that belong to bodies
/// @throws Error  on all processes: see kind_of() and check_shape(), or if a molecule is only
///                partly inside
std::vector<SiteMessage> assemble(const std::vector<AtomMessage>& atoms, std::vector<Kind>& kinds,
                                  const AssemblySettings& settings, MPI_Comm world);

}  // namespace polhode::lammps
