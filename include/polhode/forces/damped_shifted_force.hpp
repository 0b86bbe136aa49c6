// SPDX-License-Identifier: MIT
// The damped shifted force: Coulomb's law damped by erfc and ended at the cutoff a, pair by pair
// [wolf1999; fennell2006]. What is taken off there is the value and slope of erfc(α r)/r at a, as a
// line in r; here it is its Taylor polynomial in y = 1 − r²/a² up to y^n, so that energies end with
// n continuous derivatives and schemes keep their order.
#pragma once

#include <cmath>
#include <vector>

#include "polhode/base/units.hpp"
#include "polhode/forces/smooth_polynomial.hpp"

namespace polhode {

/// The largest α a: of erf(α r)/r the powers of y left out are then below 3e-7/a, below 1e-10/a for
/// α a ≤ 2.4.
inline constexpr double most_damping = 3;

/// What the law takes off 1/r: of 1/r = erf(α r)/r + erfc(α r)/r the first whole, as its Taylor
/// series in y, and the second up to y^n. So the terms up to y^n are those of 1/r, and the others
/// those of erf(α r)/r. Without damping it is the force shifted in r².
/// @param cutoff      a [nm]
/// @param damping     α [1/nm], 0 ≤ α a ≤ most_damping
/// @param smoothness  n, at least 1: then the force ends at a as well
inline SmoothPolynomial damped_shifted_force(double cutoff, double damping, int smoothness) {
  constexpr double negligible = 1e-12;
  const double x = damping * cutoff;
  std::vector<double> terms = inverse_distance_terms(smoothness);
  // g = a erf(α r)/r obeys (1 − y) g' = g/2 − x/√π e^(−x² (1 − y)).
  double g = std::erf(x), gauss = x / std::sqrt(units::pi) * std::exp(-x * x);
  for (int k = 0; k < SmoothPolynomial::most; ++k) {
    g = ((k + 0.5) * g - gauss) / (k + 1);
    gauss *= x * x / (k + 1);
    if (k + 1 <= smoothness) continue;
    if (k + 1 > x * x && std::abs(g) < negligible) break;
    terms.push_back(g);
  }
  return {cutoff, terms};
}

}  // namespace polhode
