// SPDX-License-Identifier: MIT
// Means and straight-line fits with standard errors, and their statistical significance.
#pragma once

#include <span>

namespace polhode {

struct Estimate {
  double value = 0;
  double error = 0;  ///< standard error; 0 if a single value gives no information about it
};

/// The mean of independent values and its standard error.
Estimate mean(std::span<const double> values);

/// The jackknife standard error of a value. `without` holds the values obtained by leaving out each
/// of the independent parts in turn.
double jackknife_error(std::span<const double> without);

/// The slope of the least-squares line through (x, y). The standard error is computed from the
/// residuals, which are assumed to be independent.
Estimate slope(std::span<const double> x, std::span<const double> y);

/// A straight line a + b x.
struct Line {
  Estimate intercept, slope;
  double degrees_of_freedom = 0;  ///< degrees of freedom of the errors of intercept and slope; 0 if
                                  ///< the errors are exact
};

/// Fits a line by weighted least squares to points with known, positive standard errors of y. The
/// errors of the line's parameters follow from the errors of y.
Line weighted_line(std::span<const double> x, std::span<const Estimate> y);

/// The p-value of the deviations of points from their line, by Fisher's F test. The p-value is the
/// probability that chance causes deviations at least this large. The p-value is 1 for two points.
/// The errors of y are assumed to have the degrees of freedom given in `line`.
double misfit_p_value(const Line& line, std::span<const double> x, std::span<const Estimate> y);

/// The p-value of an estimate, by a two-sided Student t test with the given degrees of freedom. The
/// p-value is the probability of an estimate at least this far from zero if the true value is zero.
/// The p-value is 1 if the estimate and its error are both 0.
double p_value(const Estimate& estimate, double degrees_of_freedom);

/// For a two-sided interval, the number of standard errors that corresponds to three standard
/// deviations of a normal distribution. This number is 6.6 for an error estimated with 4 degrees of
/// freedom. For an exact error, the argument is 0, and the number is 3.
double three_sigma_quantile(double degrees_of_freedom);

}  // namespace polhode
