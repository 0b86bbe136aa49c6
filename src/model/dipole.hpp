// SPDX-License-Identifier: MIT
// Electric dipoles of rigid molecules.
#pragma once

#include "polhode/model/molecule.hpp"

namespace polhode {

/// Σ q r about the centre of mass [e nm], body frame.
Vec3<double> dipole_moment(const Molecule& molecule);

/// Whether the dipole exceeds the rounding of the site positions.
bool has_dipole(const Molecule& molecule);

}  // namespace polhode
