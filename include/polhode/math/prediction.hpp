// SPDX-License-Identifier: MIT
// Bounds that hold with a given probability, from a few values of a normal distribution.
#pragma once

#include <span>

namespace polhode {

/// Quantile of Student's t distribution: a deviate is below it with this probability.
double t_quantile(double probability, double degrees_of_freedom);

/// One-sided prediction interval: a further value of the same normal distribution is below mean + t
/// s √(1 + 1/n) with this probability. Accounts for the scatter of that value and for the
/// uncertainty of mean and scatter estimated from n values. Infinite for fewer than two values.
double prediction_bound(std::span<const double> values, double probability);

/// Confidence bound on the magnitude of the mean of the distribution: |mean| + t s/√n. Infinite for
/// fewer than two values.
double size_bound(std::span<const double> values, double probability);

}  // namespace polhode
