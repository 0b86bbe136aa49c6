// SPDX-License-Identifier: MIT
// The order of a scheme, measured: how fast its energy error falls when the step is halved.
#pragma once

#include <vector>

#include "polhode/integrate/nested_scheme.hpp"

namespace polhode {

/// One asymmetric body without symmetry of its sites in a smooth anharmonic field: the smallest
/// scene that couples translation, rotation and all terms of the gradient kick. The near forces of
/// an inner scheme, whatever its cutoff, are the harmonic part of the field.
struct OrderMeasurement {
  struct Point {
    double step;   ///< [ps]
    double error;  ///< largest |E − E₀| along the way, over the kinetic energy at start
  };
  std::vector<Point> points;  ///< steps halved from one to the next
  double order = 0;           ///< log₂ of the last ratio of errors that rounding does not touch
  double uncertainty = 0;     ///< how much the order changed at the last halving
};

OrderMeasurement measured_order(const NestedScheme& scheme, double lambda = 1e-4);

}  // namespace polhode
