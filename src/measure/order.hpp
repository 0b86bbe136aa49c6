// SPDX-License-Identifier: MIT
// Measures the order of a scheme from the decrease of its energy error when the step is halved.
#pragma once

#include <vector>

#include "polhode/integrate/nested_scheme.hpp"

namespace polhode {

/// The measured order of a scheme. The test system is an asymmetric body with unlike sites in a
/// smooth anharmonic field. An asymmetric body with unlike sites is the smallest system that
/// couples translation, rotation and all terms of the gradient kick. For nested schemes, the
/// harmonic part of the field takes the role of the near forces, whatever the inner cutoff.
struct OrderMeasurement {
  struct Point {
    double step;   ///< time step [ps]
    double error;  ///< maximum of |E − E₀| over the run, divided by the initial kinetic energy
  };
  std::vector<Point> points;  ///< measurements, each with half the step of the previous one
  double order = 0;           ///< log₂ of the ratio of the last two errors above round-off
  double uncertainty = 0;     ///< change of the order at the last halving of the step
};

OrderMeasurement measure_order(const NestedScheme& scheme, double lambda = 1e-4);

}  // namespace polhode
