// SPDX-License-Identifier: MIT
// The smooth part of Ewald's split as a polynomial, for pairs next to the mesh of another program.
#pragma once

#include "forces/laws/smooth_polynomial.hpp"

namespace polhode {

/// The largest α a. The error of the polynomial is then below 1e-9/a, and for α a ≤ 4 below
/// 1e-12/a; that of −u'/r is below 1e-8/a³ and 1e-9/a³.
inline constexpr double max_gaussian = 4.5;

/// A polynomial that approximates erf(α r)/r up to the cutoff a: its Chebyshev series in r²/a².
/// 1/r minus the polynomial is Ewald's erfc(α r)/r, which jumps to zero at a.
/// @param cutoff  a [nm]
/// @param alpha   α [1/nm]
/// @throws Error  if α a is larger than max_gaussian
SmoothPolynomial gaussian_smooth_part(double cutoff, double alpha);

}  // namespace polhode
