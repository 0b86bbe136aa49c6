// SPDX-License-Identifier: MIT
// R of one scheme as a function of the step, from runs with a few steps from the same initial
// configurations.
#pragma once

#include <vector>

#include "polhode/math/fit.hpp"

namespace polhode {

/// R of one run from each initial configuration, all with the same step.
struct StepPoint {
  double step = 0;             ///< [ps]
  std::vector<double> ratios;  ///< R, by initial configuration
};

/// R(h) = a hᵖ exp(c h²), with p the scheme's order. It is the power law of small steps with its
/// first correction, a hᵖ (1 + c h²). This form is positive, and log R − p log h is linear in h².
/// Steps that differ by a third suffice to determine it near them. It is not meant for
/// extrapolation.
///
/// Runs with two steps from the same initial configuration are not independent: they sample the
/// same part of the trajectory. Therefore each initial configuration has its own line, and the
/// scatter of these lines gives the uncertainty of the mean line. The runs at each step give the
/// scatter of a single run.
class StepModel {
 public:
  /// @param order   p; 0 (unknown) is treated as 2
  /// @param points  at least one, each with at least two initial configurations in the same order
  StepModel(int order, const std::vector<StepPoint>& points);

  /// log R at a step, the mean over initial configurations, with its standard error.
  Estimate log_ratio(double step) const;

  /// Prediction bound: R of a new run at that step is below it with this probability, by Student's
  /// t with one degree of freedom less than there are initial configurations.
  double bound(double step, double probability) const;

  /// d log R/d log h = p + 2 c h².
  double exponent(double step) const;

  /// The largest step, up to `longest`, with a bound of at most that R.
  double max_step(double ratio, double probability, double limit) const;

 private:
  struct Line {
    double at_mean = 0, slope = 0;  ///< log R − p log h at the mean h², and its slope in h²
  };
  double value(const Line& line, double step) const;

  int order_;
  double mean_square_ = 0;  ///< mean square of h
  std::vector<Line> lines_;
  double scatter_ = 0;
};

}  // namespace polhode
