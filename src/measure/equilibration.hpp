// SPDX-License-Identifier: MIT
// Where a series becomes stationary: the end of equilibration, detected instead of assumed.
#pragma once

#include <cstddef>
#include <span>

namespace polhode {

/// The first sample of a series from which on its mean is most precise.
struct Equilibration {
  std::size_t start = 0;  ///< samples before it are discarded
  double error = 0;       ///< standard error of the mean of all later ones
};

/// The start with the smallest standard error of the mean of what follows [clark2024]. Samples of
/// the approach to equilibrium make it larger, and so does discarding too much. The variance of the
/// mean comes from autocovariances in a window of √n lags with triangular weights. The last tenth
/// is always kept.
/// @return  the whole series if it has fewer than 10 samples
Equilibration equilibration(std::span<const double> series);

}  // namespace polhode
