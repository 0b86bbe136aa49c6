// SPDX-License-Identifier: MIT
// Electric dipoles of rigid molecules.
#pragma once

#include "polhode/model/molecule.hpp"

namespace polhode {

/// The dipole moment Σ q r about the centre of mass [e nm], in the body frame.
Vec3<double> dipole_moment(const Molecule& molecule);

/// Whether the dipole moment exceeds the round-off error from the site positions.
bool has_dipole(const Molecule& molecule);

}  // namespace polhode
