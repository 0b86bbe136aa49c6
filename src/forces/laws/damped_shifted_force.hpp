// SPDX-License-Identifier: MIT
// The damped shifted force: a Coulomb potential damped by erfc and truncated at the cutoff a, pair
// by pair [wolf1999; fennell2006]. The original method subtracts the tangent of erfc(α r)/r at r =
// a, a straight line in r. This class subtracts the Taylor polynomial of erfc(α r)/r in y = 1 −
// r²/a² up to y^n. At the cutoff, the energy then goes to zero with n continuous derivatives, and
// schemes keep their order.
#pragma once

#include <cmath>
#include <vector>

#include "forces/laws/smooth_polynomial.hpp"
#include "polhode/base/units.hpp"

namespace polhode {

/// The largest allowed value of α a. Up to this limit, the omitted powers of y in erf(α r)/r are
/// below 3e-7/a; for α a ≤ 2.4 they are below 1e-10/a.
inline constexpr double max_damping = 3;

/// The polynomial that the damped shifted force subtracts from 1/r = erf(α r)/r + erfc(α r)/r. The
/// polynomial consists of the full Taylor series of the first term in y, and the series of the
/// second term up to y^n. The polynomial therefore has the terms of 1/r up to y^n, and the terms of
/// erf(α r)/r at higher powers. Without damping, the polynomial gives the force shifted in r².
/// @param cutoff      cutoff a [nm]
/// @param damping     α [1/nm] with 0 ≤ α a ≤ max_damping
/// @param smoothness  n, at least 1, so that the force also vanishes at a
inline SmoothPolynomial damped_shifted_force(double cutoff, double damping, int smoothness) {
  constexpr double negligible = 1e-12;
  const double x = damping * cutoff;
  std::vector<double> terms = inverse_distance_terms(smoothness);
  // The function g = a erf(α r)/r satisfies (1 − y) g' = g/2 − x/√π e^(−x² (1 − y)), where x = α a.
  double g = std::erf(x), gauss = x / std::sqrt(units::pi) * std::exp(-x * x);
  constexpr auto max_degree = static_cast<int>(SmoothPolynomial::max_degree);
  for (int k = 0; k < max_degree; ++k) {
    g = ((k + 0.5) * g - gauss) / (k + 1);
    gauss *= x * x / (k + 1);
    if (k + 1 <= smoothness) continue;
    if (k + 1 > x * x && std::abs(g) < negligible) break;
    terms.push_back(g);
  }
  return {cutoff, terms};
}

}  // namespace polhode
