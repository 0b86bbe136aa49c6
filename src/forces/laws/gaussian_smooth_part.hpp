// SPDX-License-Identifier: MIT
// The smooth part of Ewald's split as a polynomial, for pair interactions that are used together
// with the mesh of another program.
#pragma once

#include "forces/laws/smooth_polynomial.hpp"

namespace polhode {

/// The largest allowed value of α a. Up to this limit, the error of the polynomial is below 1e-9/a,
/// and the error of −u'/r below 1e-8/a³. For α a ≤ 4 these errors are below 1e-12/a and 1e-9/a³.
inline constexpr double max_gaussian = 4.5;

/// A polynomial that approximates erf(α r)/r up to the cutoff a by a Chebyshev series in r²/a². The
/// difference of 1/r and this polynomial is Ewald's erfc(α r)/r, which jumps to zero at a.
/// @param cutoff  cutoff a [nm]
/// @param alpha   Ewald parameter α [1/nm]
/// @throws Error  if α a is larger than max_gaussian
SmoothPolynomial gaussian_smooth_part(double cutoff, double alpha);

}  // namespace polhode
