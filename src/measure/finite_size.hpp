// SPDX-License-Identifier: MIT
// The finite-size correction of diffusion coefficients in rectangular periodic boxes.
#pragma once

#include "polhode/base/vec3.hpp"

namespace polhode {

/// The ratio Lz/Lx = Lz/Ly of a box without finite-size correction along x and y [busch2023].
inline constexpr double orthoboxy_ratio = 2.7933596497;

/// The mobility that the periodic images of a molecule take away along each axis, times the
/// viscosity [1/nm]. It is the Oseen tensor of a point force in an infinite liquid minus that in
/// the periodic box, both at the point of the force. The sum over the reciprocal lattice is
/// evaluated with Gaussians as by Ewald, to round-off [kikugawa2015]. In a cubic box of edge L each
/// component is 2.837297/(6 π L).
Vec3<double> image_mobility(const Vec3<double>& edge);

/// The amounts by which the periodic images lower the diffusion coefficients along the three axes
/// of a rectangular box [nm²/ps]. They are negative along the short axes of a long box.
/// @param viscosity  viscosity of the liquid [u/(nm ps)]
Vec3<double> finite_size_correction(double temperature, double viscosity, const Vec3<double>& edge);

}  // namespace polhode
