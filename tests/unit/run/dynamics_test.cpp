// SPDX-License-Identifier: MIT
// Fits of lines to functions of the lag.
#include <doctest/doctest.h>

#include <vector>

#include "run/properties/dynamics.hpp"
#include "run/properties/property.hpp"

using namespace polhode;

TEST_CASE("the lags of a fit do not depend on the rounding of the interval between lags") {
  std::vector<double> squares;
  for (std::size_t k = 0; k < lags; ++k) squares.push_back(static_cast<double>(k * k));
  // The slope of k² is the sum of the first and the last k.
  const double expected = static_cast<double>((lags - 1) / 3 + lags - 1);
  for (int n = 1; n < 2000; ++n) {
    const double interval = 1e-4 * n;
    CAPTURE(interval);
    CHECK(slope_between(squares, interval, fit_window(interval)) * interval ==
          doctest::Approx(expected).epsilon(1e-9));
  }
}
