// SPDX-License-Identifier: MIT
// Molecules with a known principal frame.
#pragma once

#include <string>
#include <vector>

#include "polhode/model/molecule.hpp"

namespace polhode {

/// Builds a molecule like rigid_molecule(), but keeps the frame of the sites if it is a principal
/// frame. A molecule built from the sites of another molecule is therefore the same up to
/// round-off. rigid_molecule() may choose other axes, because axes with equal moments and the signs
/// of all axes are arbitrary.
/// @throws Error  under the same conditions as rigid_molecule()
Molecule molecule_in_frame(std::string name, std::vector<Site> sites);

}  // namespace polhode
