// SPDX-License-Identifier: MIT
// Confidence and prediction bounds from a few samples of a normal distribution.
#pragma once

#include <initializer_list>
#include <span>

namespace polhode {

/// Quantile of Student's t distribution: a deviate is below the quantile with the given
/// probability.
double t_quantile(double probability, double degrees_of_freedom);
/// Quantile of the F distribution, the ratio of two estimates of one variance.
double f_quantile(double probability, double numerator_degrees, double denominator_degrees);

/// A standard error with its degrees of freedom.
struct ErrorPart {
  double error = 0, degrees_of_freedom = 0;
};

/// The error of a sum of independent estimates, with the effective degrees of freedom of Welch and
/// Satterthwaite: (Σ e²)² / Σ e⁴/ν.
ErrorPart summed(std::initializer_list<ErrorPart> parts);

/// Half-width of the two-sided 95 % confidence interval; infinite without degrees of freedom.
double confidence_half_width(const ErrorPart& part);

/// One-sided prediction bound: a further value of the same normal distribution is below mean + t s
/// √(1 + 1/n) with the given probability. The bound accounts for the scatter of the further value,
/// and for the uncertainty of the mean and scatter of n values. The bound is infinite for fewer
/// than two values.
double prediction_bound(std::span<const double> values, double probability);

/// Confidence bound on the magnitude of the mean of a distribution: |mean| + t s/√n. The
/// bound is infinite for fewer than two values.
double size_bound(std::span<const double> values, double probability);

}  // namespace polhode
