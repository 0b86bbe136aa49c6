// SPDX-License-Identifier: MIT
// Molecules whose principal frame is known.
#pragma once

#include <string>
#include <vector>

#include "polhode/model/molecule.hpp"

namespace polhode {

/// The molecule of rigid_molecule(), except that sites in a principal frame keep it: a molecule
/// made of its own sites is the same to rounding. Of equal moments the axes are arbitrary, and of
/// all axes the signs, so that rigid_molecule() may choose others.
/// @throws Error  as rigid_molecule()
Molecule molecule_in_frame(std::string name, std::vector<Site> sites);

}  // namespace polhode
