// SPDX-License-Identifier: MIT
// The contents of a system: molecules and their counts, and the constants of each body.
#pragma once

#include <cstddef>
#include <vector>

#include "polhode/base/column.hpp"
#include "polhode/model/molecule.hpp"

namespace polhode {

/// Molecule types with their counts. Bodies of the same type are contiguous, and types keep this
/// order.
struct Topology {
  struct Part {
    Molecule molecule;
    std::size_t count = 0;
  };
  std::vector<Part> parts;

  std::size_t size() const;  ///< number of bodies
  double mass() const;       ///< Total mass of all bodies [u].
  double extent() const;     ///< Largest extent of a molecule [nm], see Molecule::extent().
};

/// Mass and principal moments of inertia of each body, with their inverses. The inverse of a
/// vanishing moment is set to 0, since the angular momentum along that axis is always zero.
struct Bodies {
  Column<double> m;               ///< mass [u]
  Column<double> inverse_m;       ///< inverse mass [1/u]
  Vec3Column J;                   ///< principal moments [u nm²]
  Vec3Column inverse_J;           ///< inverse principal moments [1/(u nm²)]
  std::vector<std::size_t> part;  ///< index of the body's molecule type in Topology::parts

  explicit Bodies(const Topology& topology);
  std::size_t size() const { return part.size(); }
};

}  // namespace polhode
