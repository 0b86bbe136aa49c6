// SPDX-License-Identifier: MIT
// Bounds that hold with a stated probability, from a few values of a normal distribution.
#pragma once

#include <span>

namespace polhode {

/// The value that a Student-t deviate stays below with this probability.
double t_quantile(double probability, double degrees_of_freedom);

/// What a further value of the same normal distribution stays below with this probability: mean + t
/// s √(1 + 1/n), the one-sided prediction interval. It counts the scatter of the further value and
/// that n values know their mean and scatter only so well. Infinite for fewer than two values.
double prediction_bound(std::span<const double> values, double probability);

/// What the mean of the distribution stays below in size with this confidence: |mean| + t s/√n.
/// Infinite for fewer than two values.
double size_bound(std::span<const double> values, double probability);

}  // namespace polhode
