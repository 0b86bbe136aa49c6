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

/// R(h) = a hᵖ exp(c h²), p the scheme's order: the power law of small steps with its first
/// correction, a hᵖ (1 + c h²), in a form that is always positive and linear in h² for log R − p
/// log h. Steps that differ by a third suffice to determine it near them; it is not meant for
/// extrapolation.
///
/// Runs with two steps from the same initial configuration are not independent: they sample the
/// same part of the trajectory. Therefore each initial configuration has its own line, and the
/// uncertainty of the mean line is estimated from the scatter of these; the scatter of a single run
/// is estimated from the runs themselves, step by step.
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
    double at_mean = 0, slope = 0;  ///< of log R − p log h at the mean h², and as a function of h²
  };
  double value(const Line& line, double step) const;

  int order_;
  double mean_square_ = 0;  ///< of h
  std::vector<Line> lines_;
  double scatter_ = 0;
};

}  // namespace polhode
