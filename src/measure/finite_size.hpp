// SPDX-License-Identifier: MIT
// The finite-size correction of diffusion coefficients in rectangular periodic boxes.
#pragma once

#include "polhode/base/vec3.hpp"

namespace polhode {

/// The ratio Lz/Lx = Lz/Ly of a box without finite-size correction along x and y [busch2023].
inline constexpr double orthoboxy_ratio = 2.7933596497;

/// The loss of mobility along each axis that the periodic images of a molecule cause, times the
/// viscosity [1/nm]. The loss is the Oseen tensor of a point force in an infinite liquid minus the
/// tensor in the periodic box, at the position of the force. The sum over the reciprocal lattice is
/// computed to round-off by Ewald summation [kikugawa2015]. In a cubic box of edge L each component
/// is 2.837297/(6 π L).
Vec3<double> image_mobility(const Vec3<double>& edge);

/// The amounts by which the periodic images lower the diffusion coefficients along the three axes
/// of a rectangular box [nm²/ps]. The amounts are negative along the short axes of a long box. In a
/// cubic box of edge L they are 2.837297 k_B T/(6 π η L) [yeh2004, Eq. 12].
/// @param viscosity  viscosity of the liquid [u/(nm ps)]
Vec3<double> finite_size_correction(double temperature, double viscosity, const Vec3<double>& edge);

}  // namespace polhode
