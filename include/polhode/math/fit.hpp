// SPDX-License-Identifier: MIT
// Means and straight-line fits with standard errors, and their statistical significance.
#pragma once

#include <span>

namespace polhode {

struct Estimate {
  double value = 0;
  double error = 0;  ///< standard error; 0 where a single value gives no information about it
};

/// The mean of independent values and its standard error.
Estimate mean(std::span<const double> values);

/// The standard error of a value by the jackknife; `without` holds the values obtained by leaving
/// out one of the independent parts after the other.
double jackknife_error(std::span<const double> without);

/// The slope of the least-squares line through (x, y), and its standard error from the residuals,
/// assumed independent.
Estimate slope(std::span<const double> x, std::span<const double> y);

/// A straight line a + b x.
struct Line {
  Estimate intercept, slope;
  double degrees_of_freedom = 0;  ///< degrees of freedom of the errors; 0 if they are exact
};

/// The line through points with known standard errors of y, all positive, by weighted least
/// squares; the errors of its parameters follow from the errors of y.
Line weighted_line(std::span<const double> x, std::span<const Estimate> y);

/// p-value of the deviations of the points from their line, by Fisher's F test: the probability of
/// deviations this large by chance. The errors of y are estimated with the line's degrees of
/// freedom. 1 for two points.
double misfit_p_value(const Line& line, std::span<const double> x, std::span<const Estimate> y);

/// p-value: the probability that chance alone makes an estimate at least this far from zero, by a
/// two-sided Student t test with the given degrees of freedom. 1 if value and error are 0.
double p_value(const Estimate& estimate, double degrees_of_freedom);

/// The multiple of a standard error with these degrees of freedom that corresponds to three
/// standard deviations of a normal distribution, two-sided. It is 6.6 for 4 degrees of freedom, and
/// 3 for an exact error, given as 0.
double three_sigma_quantile(double degrees_of_freedom);

}  // namespace polhode
